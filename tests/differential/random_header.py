# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Random C++ headers, and what is known of them: each struct with its fields, each enum with its names."""
import random
from typing import NamedTuple

from random_types import SCALARS, UNDERLYING, INCLUDES, RandomTypes, enum_body


HEAVY = 20000  # bytes, roughly: larger ones are part of nothing else


class Field(NamedTuple):
    name: str   # as typegen calls it
    how: str    # 'offset', 'either' (packed), 'bits', 'copied'
    told: dict  # unit, range, doc


class Struct:
    def __init__(self, name):
        self.name = name
        self.fields = []
        self.plain = True    # may be a base class: its field names are its own
        self.sample = True   # can be assigned, so may be an element
        self.empty = False
        self.overlaps = False  # has [[no_unique_address]]: compilers do not agree on what may stand in the padding at its end
        self.inherited = set()


class RandomHeader:
    def __init__(self, seed, count):
        self.random = random.Random(seed)
        self.types = RandomTypes(self.random)
        self.structs, self.enums, self.lines = [], [], []
        self.spaces = ['alpha', 'alpha::inner', 'beta', 'alpha::inner::deep', 'delta::v1']
        for index in range(count):
            self.add_type(index)

    def text(self):
        head = ['#pragma once'] + [f'#include <{name}>' for name in INCLUDES] + ['namespace delta { inline namespace v1 {} }']
        return '\n'.join(head + self.lines) + '\n'

    def add_type(self, index):
        space = self.random.choice(self.spaces)
        self.lines.append(f'namespace {space} {{')
        pick = self.random.random()
        if pick < 0.15:
            self.add_enum(f'E{index}', space)
        elif pick < 0.23:
            self.add_instance(f'T{index}', space)
        else:
            self.add_struct(f'S{index}', space)
        self.lines.append('}')

    def add_enum(self, name, space):
        base = self.random.choice(list(UNDERLYING))
        scoped = self.random.random() < 0.5
        names, body = enum_body(self.random, name, base)
        colon = f' : {base}' if base else ''
        self.lines.append(f'enum {"class " if scoped else ""}{name}{colon} {{ {body} }};')
        self.enums.append((f'{space}::{name}', names))
        self.types.enums.append(f'{space}::{name}')

    def add_instance(self, name, space):
        """A template, and an instance that an alias asks for."""
        count = self.random.randint(1, 4)
        self.lines += [f'template <class T, int N> struct {name} {{ T {name.lower()}_first; T {name.lower()}_more[N]; }};',
                       f'using A{name} = {name}<{self.types.value()}, {count}>;']
        struct = Struct(f'{space}::A{name}')
        struct.fields = [Field(f'{name.lower()}_{part}', 'offset', {}) for part in ('first', 'more')]
        struct.plain = False
        self.add_known(struct, len(self.lines) - 1, count + 1)

    def add_known(self, struct, first_line, times=1):
        """`first_line`: of the header, where the struct begins, which is there `times` times in itself."""
        self.structs.append(struct)
        weight = times * sum(self.types.weight_of(line) for line in self.lines[first_line:])
        if struct.sample and weight < HEAVY:
            self.types.add_struct(struct.name, weight)
        struct.plain = struct.plain and weight < HEAVY

    def add_struct(self, name, space):
        struct = Struct(f'{space}::{name}')
        bases = self.bases(struct)
        packed = not bases and self.random.random() < 0.05
        aligned = '' if packed or self.random.random() > 0.05 else f' alignas(32)'
        attribute = ' __attribute__((packed))' if packed else ''
        colon = ' : ' + ', '.join(f'::{base.name}' for base in bases) if bases else ''
        self.lines.append(f'struct{attribute}{aligned} {name}{colon} {{')
        before = len(self.lines)
        for index in range(self.random.randint(0, 8)):
            field = f'{name.lower()}_{index}'
            if packed:
                self.add_packed(struct, field)
            else:
                self.add_field(struct, field)
        struct.empty = len(self.lines) == before and not bases
        if self.random.random() < 0.2:
            self.lines.append(f'    static constexpr int kSize = {self.random.randint(1, 9)};')
        self.lines.append('};')
        struct.plain = not packed and not aligned and not struct.overlaps
        struct.inherited |= {field.name for field in struct.fields}
        self.add_known(struct, before - 1)

    def bases(self, struct):
        candidates = [s for s in self.structs[-20:] if s.plain]
        if not candidates or self.random.random() > 0.2:
            return []
        bases = []
        for base in self.random.sample(candidates, min(len(candidates), self.random.randint(1, 2))):
            if not struct.inherited & base.inherited:
                bases.append(base)
                struct.inherited |= base.inherited
                struct.fields += base.fields
                struct.sample = struct.sample and base.sample
        return bases

    def add_packed(self, struct, name):
        self.lines.append(f'    {self.random.choice(["char", "double", "short", "int"])} {name};')
        struct.fields.append(Field(name, 'either', {}))

    def add_field(self, struct, name):
        pick = self.random.random()
        if pick < 0.28:
            self.random.choice([self.add_bits, self.add_anonymous, self.add_private, self.add_constant, self.add_hidden,
                                self.add_text, self.add_union, self.add_unnamed_enum, self.add_nested,
                                self.add_restricted, self.add_empty, self.add_pointer, self.add_rows])(struct, name)
            return
        bounds = ''.join(f'[{self.random.randint(1, 4)}]' for _ in range(self.random.choice([0, 0, 0, 0, 1, 1, 2, 3])))
        self.add_told(struct, name, lambda: f'{self.types.value()} {name}{bounds};', 'offset')

    def add_told(self, struct, name, declaration, how):
        """With a comment or attributes, or without."""
        told, before, behind = {}, '', ''
        if self.random.random() < 0.2:
            unit, low = self.random.choice(['m', 'm/s', 'rad', 'kg m^2', '1/s']), self.random.randint(-9, 9)
            told = {'unit': unit, 'range': f'{low}..{low + 5}', 'doc': f'what {name} is'}
            words = f'what {name} is @unit {unit} @range {low}..{low + 5}'
            form = self.random.randrange(3)
            if form == 0:
                behind = f'  ///< {words}'
            elif form == 1:
                before = f'/** {words} */ '
            else:
                before = f'[[oro::unit("{unit}"), oro::range({low}, {low + 5})]] [[oro::doc("what {name} is")]] '
        self.lines.append(f'    {before}{declaration()}{behind}')
        struct.fields.append(Field(name, how, told))

    def add_bits(self, struct, name):
        kind, most = self.random.choice([('unsigned', 32), ('int', 32), ('short', 16), ('bool', 1), ('long long', 60),
                                         ('std::uint8_t', 8), ('char', 8), ('unsigned long', 64)])
        if self.random.random() < 0.2:
            self.lines.append(f'    {self.random.choice(["int : 0", "unsigned : 3", "char : 0"])};')
        self.add_told(struct, name, lambda: f'{kind} {name} : {self.random.randint(1, most)};', 'bits')

    def add_anonymous(self, struct, name):
        self.lines.append(f'    struct {{ int {name}_in; double {name}_side; }};')
        struct.fields += [Field(f'{name}_in', 'offset', {}), Field(f'{name}_side', 'offset', {})]

    def add_private(self, struct, name):
        kind = self.random.choice(SCALARS + ['std::string', 'std::vector<int>'])
        private = self.random.choice([f'{name}_', f'm_{name}', f'_{name}'])
        setter = self.random.choice([f'void set_{name}(const {kind}& v) {{ {private} = v; }}',
                                     f'void {name}({kind} v) {{ {private} = v; }}', f'{kind}& {name}() {{ return {private}; }}'])
        getter = f'{self.random.choice([kind, f"const {kind}&"])} {name}() const {{ return {private}; }}'
        self.lines.append(f'    {getter} {setter} private: {kind} {private}; public:')
        struct.fields.append(Field(name, 'copied', {}))

    def add_constant(self, struct, name):
        kind, bounds = self.random.choice([('int', ''), ('double', ''), ('std::string', ''), ('short', '[3]'), ('bool', '[2][2]')])
        self.lines.append(f'    const {kind} {name}{bounds} = {{}};')
        struct.fields.append(Field(name, 'copied', {}))
        struct.sample = False

    def add_restricted(self, struct, name):
        """A field of a struct that cannot be assigned, itself not in a container."""
        known = [s.name for s in self.structs[-30:] if not s.sample and s.plain]
        if not known:
            return
        self.lines.append(f'    ::{self.random.choice(known)} {name};')
        struct.fields.append(Field(name, 'offset', {}))
        struct.sample = False

    def add_hidden(self, _, name):
        self.lines.append(f'    {self.random.choice(["[[oro::skip]] ", "/** @skip */ "])}void* {name} = nullptr;')

    def add_text(self, struct, name):
        size = self.random.randint(1, 40)
        kind = self.random.choice([f'char {name}[{size}]', f'std::array<char, {size}> {name}'])
        self.lines.append(f'    [[oro::text]] {kind};')
        struct.fields.append(Field(name, 'copied', {}))

    def add_union(self, struct, name):
        self.lines.append(f'    [[oro::bytes]] union {{ {self.random.choice(SCALARS)} a; double b; char c[{self.random.randint(1, 20)}]; }} {name};'
                          if self.random.random() < 0.5 else
                          f'    union [[oro::bytes]] {name}_t {{ int i; float f; }}; {name}_t {name};')
        struct.fields.append(Field(name, 'copied', {}))

    def add_unnamed_enum(self, struct, name):
        self.lines.append(f'    enum {{ {name}_a = {self.random.choice([-1, 0, 70000])}, {name}_b }} {name};')
        struct.fields.append(Field(name, 'copied', {}))

    def add_nested(self, struct, name):
        inner = f'In_{name}'
        self.lines.append(f'    struct {inner} {{ {self.types.value()} {name}_x; }}; {inner} {name};')
        struct.fields.append(Field(name, 'offset', {}))

    def add_empty(self, struct, name):
        known = [s.name for s in self.structs if s.empty]
        if not known:
            return
        unique = self.random.random() < 0.5
        struct.overlaps |= unique
        self.lines.append(f'    {"[[no_unique_address]] " if unique else ""}::{self.random.choice(known)} {name};')
        struct.fields.append(Field(name, 'copied' if unique else 'offset', {}))

    def add_rows(self, struct, name):
        """Arrays that are written in two ways."""
        inner = f'{self.types.value()}[{self.random.randint(1, 3)}]'
        self.lines.append(f'    std::array<{inner}, {self.random.randint(1, 4)}> {name}{self.random.choice(["", "[2]", "[2][3]"])};')
        struct.fields.append(Field(name, 'offset', {}))

    def add_pointer(self, struct, name):
        self.lines.append(f'    [[oro::by_value]] std::shared_ptr<{self.types.value()}> {name};')
        struct.fields.append(Field(name, 'copied', {}))
