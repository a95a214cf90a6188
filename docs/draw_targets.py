#!/usr/bin/env python3
"""Draws the libraries and programs of a build folder, and what they link, as docs/images/targets.dot and .svg.

   draw_targets.py BUILD           BUILD/targets.txt is written by CMake; needs graphviz
   draw_targets.py BUILD --check   only compares with docs/images/targets.dot; exit 1 where they differ

An arrow points to what is linked. Links that follow from others are left out: a -> c where a -> b -> c.
"""
import pathlib
import subprocess
import sys

IMAGES = pathlib.Path(__file__).resolve().parent / 'images'
FOLDERS = {'runtime': '#e8f1fa', 'fitter': '#eaf5ea', 'sample_app': '#fdf3e3', 'plugin': '#f3eafa'}
# Packages that say what a part costs; the others are header-only or small.
PACKAGES = {
    'PkgConfig::OIIO': 'OpenImageIO', 'Eigen3::Eigen': 'Eigen', 'Ceres::ceres': 'Ceres', 'MPI::MPI_C': 'MPI',
    'pugixml::pugixml': 'pugixml', 'PNG::PNG': 'libpng', 'fbrdf_osg': 'OpenSceneGraph', 'fbrdf_ogre': 'OGRE', 'glfw': 'GLFW',
    'PkgConfig::IMGUI': 'Dear ImGui', 'OpenGL::EGL': 'EGL', 'PkgConfig::OPENEXR': 'OpenEXR', 'PkgConfig::OPENEXRCORE': 'OpenEXR',
    'embree': 'Embree', 'OpenEXR::OpenEXRCore': 'OpenEXR', 'OpenEXR::OpenEXR': 'OpenEXR',
}


def read(path):
    """{name: (type, folder)} and {name: set of linked names}."""
    targets, links = {}, {}
    for line in path.read_text().splitlines():
        kind, name, *rest = line.split()
        if kind == 'target':
            targets[name], links[name] = tuple(rest), set()
        elif rest:
            links[name].add(rest[0].replace('fbrdf::', 'fbrdf_'))
    return targets, links


def reach(name, links, seen):
    for linked in links.get(name, ()):
        if linked not in seen:
            seen.add(linked)
            reach(linked, links, seen)
    return seen


def direct(name, links, targets):
    """What a target links and does not get through another one that it links."""
    ours = links[name] & targets.keys()
    through = set()
    for linked in ours:
        through |= reach(linked, links, set())
    return sorted(ours - through)


def node(name, targets, links):
    kind, folder = targets[name]
    packages = sorted({PACKAGES[linked] for linked in links[name] if linked in PACKAGES})
    lines = [f'<b>{name}</b>', folder] + ([f'<i>{", ".join(packages)}</i>'] if packages else [])
    shape = 'box3d' if kind == 'EXECUTABLE' else 'component' if kind in ('SHARED_LIBRARY', 'MODULE_LIBRARY') else 'box'
    return f'    "{name}" [shape={shape}, label=<{"<br/>".join(lines)}>];'


def drawing(targets, links):
    out = ['digraph targets {', '  rankdir=BT; ranksep=0.5; nodesep=0.25;',
           '  node [fontname="Helvetica", fontsize=11, style=filled, fillcolor=white];',
           '  edge [color="#57606a", arrowsize=0.7];', '  fontname="Helvetica";']
    for folder, colour in FOLDERS.items():
        names = sorted(name for name in targets if targets[name][1].split('/')[0] == folder)
        if names:
            out += [f'  subgraph "cluster_{folder}" {{',
                    f'    label="{folder}"; style=filled; color="{colour}"; fillcolor="{colour}";']
            out += [node(name, targets, links) for name in names] + ['  }']
    out += [f'  "{name}" -> "{linked}";' for name in sorted(targets) for linked in direct(name, links, targets)]
    return '\n'.join(out + ['}']) + '\n'


def main():
    build, *options = sys.argv[1:]
    text = drawing(*read(pathlib.Path(build) / 'targets.txt'))
    dot = IMAGES / 'targets.dot'
    if options == ['--check']:
        if not dot.exists() or dot.read_text() != text:
            sys.exit(f'docs/images/targets.dot: found other targets than {build} has; run docs/draw_targets.py {build}')
        return
    dot.write_text(text)
    subprocess.run(['dot', '-Tsvg', '-o', str(dot.with_suffix('.svg')), str(dot)], check=True)


main()
