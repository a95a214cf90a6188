#!/usr/bin/env python3
"""Copies programs, and every shared library that they need, into a folder that runs on another Linux machine of the same
architecture and a C library no older than this one's. tests/run-gpu.sh calls it.

usage: pack.py FOLDER FILE...     FILE: a program, or a library that programs open by name (goes to FOLDER/lib)

The C library and what belongs to a graphics driver stay those of the other machine. OpenImageIO brings 350 MB of codecs
that no test here calls; a library whose name matches UNUSED becomes one of the same name and symbols without content."""
import os
import re
import shutil
import subprocess
import sys
import tempfile

UNUSED = re.compile(r'openvdb|gdal|opencv|avcodec|avformat|avutil|swscale|heif|libraw|dcm|ofstd|oflog')
OF_THE_MACHINE = re.compile(r'^(libc|libm|libpthread|libdl|librt|ld-linux.*|libGL|libGLX|libOpenGL)\.so')
OBJECTS = set('VvDBdbRr')  # letters of nm that stand for data


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


def places(files):
    """Where the loader finds each library that any of the files needs, by name."""
    return {match[1]: os.path.realpath(match[2]) for file in files
            for match in re.finditer(r'^\s*(\S+) => (/\S+)', output('ldd', file), re.M)}


def needed(file):
    return re.findall(r'NEEDED.*\[(.*)\]', output('readelf', '-d', file))


def symbols(file, which):
    """(name, version, letter of nm) of each dynamic symbol."""
    for line in output('nm', '-D', which, file).splitlines():
        *_, letter, symbol = line.split()
        name, _, version = symbol.partition('@')
        yield name, version.lstrip('@'), letter


def closure(files, where):
    """Names of all libraries that are needed, and of those that are left without content."""
    kept, emptied, todo = set(), set(), list(files)
    while todo:
        for name in needed(todo.pop()):
            if name in kept or name in emptied or name not in where:
                continue
            if UNUSED.search(name):
                emptied.add(name)  # nor what it needs itself
            else:
                kept.add(name)
                todo.append(where[name])
    return kept, emptied


def write_empty(library, name, wanted, target):
    """A library with the symbols of `library` that are wanted: functions that return, data of zeros."""
    found = [s for s in symbols(library, '--defined-only') if s[0] in wanted]
    text = ['.data', '.align 16', 'zeros: .zero 65536']
    for symbol in sorted({(n, letter) for n, _, letter in found}):
        text.append('.globl "%s"' % symbol[0])
        if symbol[1] in OBJECTS:
            text += ['.type "%s",@object' % symbol[0], '.size "%s",4096' % symbol[0], '.data', '.align 16',
                     '"%s": .zero 4096' % symbol[0]]
        else:
            text += ['.type "%s",@function' % symbol[0], '.text', '"%s": lea zeros(%%rip),%%rax' % symbol[0], 'ret']
    versions = {}
    for symbol, version, _ in found:
        if version:
            versions.setdefault(version, set()).add(symbol)
    with tempfile.TemporaryDirectory() as folder:
        source, script = os.path.join(folder, 'empty.s'), os.path.join(folder, 'versions')
        with open(source, 'w', encoding='utf-8') as file:
            file.write('\n'.join(text) + '\n.section .note.GNU-stack,"",@progbits\n')
        command = ['gcc', '-shared', '-nostdlib', '-o', os.path.join(target, name), '-Wl,-soname,' + name, source]
        if versions:
            with open(script, 'w', encoding='utf-8') as file:
                for version, names in versions.items():
                    file.write('%s { global: %s };\n' % (version, ' '.join('"%s";' % n for n in sorted(names))))
            command.append('-Wl,--version-script=' + script)
        subprocess.run(command, check=True)


def copy(file, target):
    shutil.copy(file, target)
    subprocess.run(['strip', '--strip-unneeded', os.path.join(target, os.path.basename(file))], check=True)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folder, files = sys.argv[1], sys.argv[2:]
    libraries = os.path.join(folder, 'lib')
    os.makedirs(libraries, exist_ok=True)
    where = places(files)
    kept, emptied = closure(files, where)
    wanted = {name for user in files + [where[k] for k in kept] for name, _, _ in symbols(user, '--undefined-only')}
    for name in sorted(emptied):
        write_empty(where[name], name, wanted, libraries)
    for name in sorted(kept):
        if not OF_THE_MACHINE.match(name):
            shutil.copy(where[name], os.path.join(libraries, name))
            subprocess.run(['strip', '--strip-unneeded', os.path.join(libraries, name)], check=True)
    for file in files:
        copy(file, libraries if '.so' in os.path.basename(file) else folder)


if __name__ == '__main__':
    main()
