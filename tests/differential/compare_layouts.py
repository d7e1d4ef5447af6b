#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""compare_layouts.py TYPEGEN COMPILER… : what typegen says of random headers, against what a compiled program says.

Every struct and enum of the headers must be there, with every field; sizes, alignments, offsets and the values of
enumerators must be the program's. LAYOUT_SEEDS=100 LAYOUT_FIRST=… searches for longer.
"""
import json
import os
import subprocess
import sys
import tempfile

from random_header import RandomHeader

TYPES_PER_HEADER = 200


def program(header):
    """Prints what the compiler knows, one JSON value a line."""
    lines = ['#include "types.hpp"', '#include <cstdio>', '#include <type_traits>',
             'template <class E> void value(E e) {',
             '    using U = std::underlying_type_t<E>;',
             '    if (std::is_unsigned_v<U>) std::printf("\\"%llu\\"", static_cast<unsigned long long>(static_cast<U>(e)));',
             '    else std::printf("\\"%lld\\"", static_cast<long long>(static_cast<U>(e)));',
             '}',
             '#pragma GCC diagnostic ignored "-Winvalid-offsetof"',
             'int main() {']
    for struct in header.structs:
        lines.append(f'    std::printf("[\\"{struct.name}\\", %zu, %zu", sizeof({struct.name}), alignof({struct.name}));')
        for field, kind in struct.fields:
            if kind == 'copied':
                lines.append(f'    std::printf(", [\\"{field}\\", null]");')
            else:
                lines.append(f'    std::printf(", [\\"{field}\\", %zu]", __builtin_offsetof({struct.name}, {field}));')
        lines.append('    std::printf("]\\n");')
    for enum, names in header.enums:
        lines.append(f'    std::printf("[\\"{enum}\\", %zu", sizeof({enum}));')
        for name in names:
            lines.append(f'    std::printf(", [\\"{name}\\", "); value({enum}::{name}); std::printf("]");')
        lines.append('    std::printf("]\\n");')
    return '\n'.join(lines + ['}']) + '\n'


def differences(header, model, truth):
    structs = {struct['cpp'][2:]: struct for struct in model['structs']}
    enums = {enum['cpp'][2:]: enum for enum in model['enums']}
    for name, *facts in truth:
        if name in enums:
            enum = enums[name]
            if enum['size'] != facts[0]:
                yield f'enum {name}: size {enum["size"]}, not {facts[0]}'
            if [[v['name'], v['value']] for v in enum['values']] != facts[1:]:
                yield f'enum {name}: values {enum["values"]}, not {facts[1:]}'
        elif name in structs:
            yield from struct_differences(structs[name], facts)
        else:
            yield f'{name} is missing'


def struct_differences(struct, facts):
    if [struct['size'], struct['align']] != facts[:2]:
        yield f'{struct["cpp"]}: size and alignment {struct["size"]}, {struct["align"]}, not {facts[:2]}'
    fields = {field['name']: field for field in struct['fields']}
    for name, offset in facts[2:]:
        if name not in fields:
            yield f'{struct["cpp"]}::{name} is missing'
        elif 'offset' in fields[name] and fields[name]['offset'] != offset:
            yield f'{struct["cpp"]}::{name}: offset {fields[name]["offset"]}, not {offset}'
        elif 'offset' not in fields[name] and 'load' not in fields[name]:
            yield f'{struct["cpp"]}::{name}: cannot be reached'
    if len(fields) != len(facts) - 2:
        yield f'{struct["cpp"]}: {len(fields)} fields, not {len(facts) - 2}'


def run(command, folder):
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
    if done.returncode != 0:
        sys.exit(f'{" ".join(command)} failed with status {done.returncode}:\n{done.stderr[-4000:]}')
    return done.stdout


def compare(seed, typegen, compiler):
    header = RandomHeader(seed, TYPES_PER_HEADER)
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (('types.hpp', header.text()), ('program.cpp', program(header))):
            with open(os.path.join(folder, name), 'w', encoding='utf-8') as file:
                file.write(text)
        model = json.loads(run([typegen, '--dump=model', 'random', 'types.hpp'], folder))
        run(compiler + ['-w', '-O0', '-o', 'program', 'program.cpp'], folder)
        truth = [json.loads(line) for line in run(['./program'], folder).splitlines()]
    assert len(truth) == TYPES_PER_HEADER
    return list(differences(header, model, truth))


def main():
    typegen, compiler = os.path.abspath(sys.argv[1]), sys.argv[2:]
    first, count = int(os.environ.get('LAYOUT_FIRST', '1')), int(os.environ.get('LAYOUT_SEEDS', '5'))
    wrong = 0
    for seed in range(first, first + count):
        for difference in compare(seed, typegen, compiler):
            print(f'seed {seed}: {difference}')
            wrong += 1
    print(f'{count * TYPES_PER_HEADER} types compared, {wrong} differences')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
