#!/usr/bin/env bash
# auto.sh - prints, for measured data, the errors of `auto` on all samples beside those of every named form within the
# same budget of bytes and look-ups, with the seconds and processor time of each fit. For isotropic data those are the
# isotropic forms: maps over directions are free to be anything at azimuths that were not measured. Fails where a form
# is better than `auto` by more than 5 % in log_median, cos_rms or cuberoot_rms and not worse by more in another of them.
# With --pictures, the path of fbrdf-viewer, knots of `auto` and of the named form of the least cuberoot_rms are compared as
# well where the data are scattered, and it fails where they are less than 30 dB from each other.
# Usage: fitter/auto.sh [--seconds S] [--pictures VIEWER] [path of fbrdf] [file or model...]
#        without files: those in ../shared/data; with --nets: its networks of MERL's materials
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
seconds=10 viewer='' nets=''
while true; do
  case ${1:-} in
    --seconds) seconds=$2; shift 2 ;;
    --pictures) viewer=$2; shift 2 ;;
    --nets) nets=yes; shift ;;
    *) break ;;
  esac
done
fbrdf=${1:-$root/build/bin/fbrdf}
[ $# -eq 0 ] || shift
data=$root/../shared/data
if [ -n "$nets" ]; then
  mapfile -t names < <(awk '$1 == "merl" { print $2 }' "$data/nbrdf/materials.txt")
  set -- "${names[@]/#/$data/nbrdf/nbrdf_weights.f32#}"
fi
[ $# -gt 0 ] || set -- "$data"/cornell_pbrt2/*.brdf "$data/nist_ptfe/PTFE.data.csv@0.532" "$data"/cea_retro/retro-3M-jaune.dat \
  "$data"/cars_airborne/*.csv "$data"/starlink_lab/*.csv "$data"/ua_rt300s/csv/*.csv "$data"/klems_fabric/*.xml \
  "$data"/rgl_iso_rgb/*.bsdf
exec python3 - "$fbrdf" "$viewer" "$seconds" "$@" <<'PYTHON'
import json, os, resource, subprocess, sys, tempfile

fbrdf, viewer, seconds, sources = sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:]
ALLOWED, BYTES, LOOKUPS, PSNR = 1.05, 32768, 2, 30.0
ISOTROPIC = ["hdio", "hdg", "hdp", "hdpio", "hdpu"]
FORMS = ISOTROPIC + ["pqp", "pqpr", "qdio", "qdg", "pqtr"]
ERRORS = ["log_median", "cos_rms", "cuberoot_rms"]

def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime

def fit(source, form, folder):
    before = processor_seconds()
    run = subprocess.run([fbrdf, "fit", source, "-o", os.path.join(folder, form + ".fbrdf"), "--form", form, "--json",
                          "--max-bytes", str(BYTES), "--lookups", str(LOOKUPS), "--seconds", seconds],
                         capture_output=True, text=True)
    if run.returncode: return None, run.stderr.strip()
    result = json.loads(run.stdout)
    result["processor"] = processor_seconds() - before
    return result, None

def info(source):
    return json.loads(subprocess.run([fbrdf, "info", source, "--json"], capture_output=True, text=True, check=True).stdout)

def psnr_of_knots(folder, form):
    """PSNR in dB of the knot of auto against that of a named form, under six lights, in codes of sRGB."""
    stats = os.path.join(folder, "stats.json")
    subprocess.run([viewer, "--headless", "--material", os.path.join(folder, "auto.fbrdf"), "--mesh", "knot", "--light-count", "6",
                    "--exposure", "2", "--compare", "drawn", os.path.join(folder, form + ".fbrdf"), "--stats", stats,
                    "-o", os.path.join(folder, "knots.png")], capture_output=True, check=True)
    with open(stats) as file: return json.load(file)["compare"]["psnr_srgb"]

def most_above(a, b):
    return max((a[e] or 0) / b[e] if b[e] else 1 for e in ERRORS)

def line(name, result, mark):
    all_errors = result["errors"]["all"]
    print(f"  {name:10} {result['form']:10} {result['bytes']:6} B {result['seconds']['fit']:7.2f} s {result['processor']:7.2f} s cpu  " +
          "  ".join(f"{e} {all_errors[e] if all_errors[e] is not None else float('nan'):.4f}" for e in ERRORS) + mark)

failed = differ = 0
with tempfile.TemporaryDirectory() as folder:
    for source in sources:
        print(os.path.basename(source), flush=True)
        auto, why = fit(source, "auto", folder)
        if not auto:
            print("  " + why); failed += 1; continue
        line("auto", auto, "")
        print("  " + auto["reason"])
        facts, least = info(source), {}
        for form in ISOTROPIC if facts["isotropic"] else FORMS:
            named, why = fit(source, form, folder)
            if not named: continue  # a form that the data do not allow
            least[form] = named["errors"]["all"]["cuberoot_rms"]
            above = most_above(auto["errors"]["all"], named["errors"]["all"])
            better = above > ALLOWED and above >= most_above(named["errors"]["all"], auto["errors"]["all"])
            failed += better
            line(form, named, f"  better by {100 * (above - 1):.0f} %" if better else "")
            sys.stdout.flush()
        if viewer and least and not facts["has_function"]:
            form = min(least, key=least.get)
            psnr = psnr_of_knots(folder, form)
            differ += psnr is not None and psnr < PSNR
            print(f"  knot: {'equal to' if psnr is None else f'{psnr:.1f} dB from'} that of {form}")
print(f"{failed} forms are better than auto" if failed else "auto is as good as every named form")
if differ: print(f"{differ} knots are less than {PSNR:.0f} dB from that of the best named form")
sys.exit(1 if failed or differ else 0)
PYTHON
