#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""compare_layouts.py TYPEGEN COMPILER… : what typegen says of random headers, against what a compiled program says.

Every struct and enum of the headers must be there, with every field; sizes, alignments, offsets, bits of bit-fields and the
values of enumerators must be the program's; the C++ types of fields, and the code that reaches them, must compile; units, ranges
and comments must be there. LAYOUT_SEEDS=100 LAYOUT_FIRST=… searches for longer.
"""
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

from random_header import RandomHeader

TYPES_PER_HEADER = 200
# A function that reaches a field without an address, in a generated file.
ACCESS = re.compile(r'\[\]\((?:const )?void\* .*?\n {12}\}', re.DOTALL)


PROGRAM_HEAD = """#include "types.hpp"
#include <cstdio>
#include <cstring>
#include <type_traits>
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
template <class E> void value(E e) {
    using U = std::underlying_type_t<E>;
    if (std::is_unsigned_v<U>) std::printf("\\"%llu\\"", static_cast<unsigned long long>(static_cast<U>(e)));
    else std::printf("\\"%lld\\"", static_cast<long long>(static_cast<U>(e)));
}
template <class S, class Fill> void bits(Fill fill) {
    alignas(S) static unsigned char raw[sizeof(S)];
    std::memset(raw, 0, sizeof raw);
    fill(*reinterpret_cast<S*>(raw));
    int first = -1, count = 0;
    for (unsigned i = 0; i != 8 * sizeof raw; ++i)
        if (raw[i / 8] >> i % 8 & 1 && count++ == 0) first = static_cast<int>(i);
    std::printf("%d, %d]", first, count);
}
"""


def program(header, model, generated):
    """Prints what the compiler knows, one JSON value a line; and compiles what generated code would do with each field."""
    functions = ACCESS.findall(generated)
    assert len(functions) >= sum('access' in field for struct in model['structs'] for field in struct['fields'])
    lines = [PROGRAM_HEAD] + declared_types(model)
    lines += [f'const auto access_{number} = {function};' for number, function in enumerate(functions)]
    lines.append('int main() {')
    for struct in header.structs:
        lines.append(f'    std::printf("[\\"{struct.name}\\", %zu, %zu", sizeof({struct.name}), alignof({struct.name}));')
        for field in struct.fields:
            name = field.name
            if field.how == 'copied':
                lines.append(f'    std::printf(", [\\"{name}\\"]");')
            elif field.how == 'bits':
                lines.append(f'    std::printf(", [\\"{name}\\", "); bits<{struct.name}>([](auto& s) {{ '
                             f's.{name} = static_cast<decltype(s.{name})>(~0ULL); }});')
            else:
                lines.append(f'    std::printf(", [\\"{name}\\", %zu]", 8 * __builtin_offsetof({struct.name}, {name}));')
        lines.append('    std::printf("]\\n");')
    for enum, names in header.enums:
        lines.append(f'    std::printf("[\\"{enum}\\", %zu", sizeof({enum}));')
        for name in names:
            lines.append(f'    std::printf(", [\\"{name}\\", "); value({enum}::{name}); std::printf("]");')
        lines.append('    std::printf("]\\n");')
    return '\n'.join(lines + ['}']) + '\n'


def declared_types(model):
    return [f'static_assert(std::is_same_v<decltype({struct["cpp"]}::{field["name"]}), '
            f'{field.get("declared", field["type"]["cpp"])}>);'
            for struct in model['structs'] for field in struct['fields'] if 'access' not in field]


def differences(header, model, truth):
    structs = {struct['cpp'][2:]: struct for struct in model['structs']}
    # An instance of a template has the name of its alias.
    structs.update({struct['name'][1:].replace('/', '::'): struct for struct in model['structs']})
    enums = {enum['cpp'][2:]: enum for enum in model['enums']}
    known = {struct.name: struct for struct in header.structs}
    for name, *facts in truth:
        if name in enums:
            enum = enums[name]
            if enum['size'] != facts[0]:
                yield f'enum {name}: size {enum["size"]}, not {facts[0]}'
            if [[v['name'], v['value']] for v in enum['values']] != facts[1:]:
                yield f'enum {name}: values {enum["values"]}, not {facts[1:]}'
        elif name in structs:
            yield from struct_differences(structs[name], facts, known[name])
        else:
            yield f'{name} is missing'


def struct_differences(struct, facts, known):
    if [struct['size'], struct['align']] != facts[:2]:
        yield f'{struct["cpp"]}: size and alignment {struct["size"]}, {struct["align"]}, not {facts[:2]}'
    if struct.get('assignable', True) != known.sample:
        yield f'{struct["cpp"]}: {"can" if known.sample else "cannot"} be assigned'
    fields = {field['name']: field for field in struct['fields']}
    told = {field.name: field.told for field in known.fields}
    for name, *places in facts[2:]:
        subject = f'{struct["cpp"]}::{name}'
        if name not in fields:
            yield f'{subject} is missing'
            continue
        field = fields[name]
        found = [8 * field['offset'] if 'offset' in field else field['bit']] if 'offset' in field or 'access' in field else []
        if not found:
            yield f'{subject}: cannot be reached'
        elif places and found + ([field['width']] if 'width' in field else []) != places:
            yield f'{subject}: at bit {found}, width {field.get("width")}, not {places}'
        for key, text in told[name].items():
            if field.get(key) != text:
                yield f'{subject}: {key} {field.get(key)!r}, not {text!r}'
    if len(fields) != len(facts) - 2:
        yield f'{struct["cpp"]}: {len(fields)} fields, not {len(facts) - 2}'


def run(command, folder):
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
    if done.returncode != 0:
        sys.exit(f'{" ".join(command)} failed with status {done.returncode}:\n{done.stderr[-4000:]}')
    return done.stdout


def read(path):
    with open(path, encoding='utf-8') as file:
        return file.read()


def write(path, text):
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)


def compare(seed, typegen, compiler):
    header = RandomHeader(seed, TYPES_PER_HEADER)
    with tempfile.TemporaryDirectory() as folder:
        write(os.path.join(folder, 'types.hpp'), header.text())
        model = json.loads(run([typegen, '--dump=model', 'random', 'types.hpp'], folder))
        run([typegen, '-o', 'out', 'random', 'types.hpp'], folder)
        generated = ''.join(read(file) for file in sorted(glob.glob(os.path.join(folder, 'out', 'types_*.cpp'))))
        write(os.path.join(folder, 'program.cpp'), program(header, model, generated))
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
