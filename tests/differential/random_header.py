# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Random C++ headers, and what is known of them: each struct with its fields, each enum with its names."""
import random

SCALARS = ['bool', 'char', 'signed char', 'unsigned char', 'short', 'unsigned short', 'int', 'unsigned', 'long',
           'unsigned long', 'long long', 'unsigned long long', 'float', 'double', 'std::size_t', 'std::int16_t']
UNDERLYING = {'': (-2 ** 31, 2 ** 31 - 1), 'signed char': (-128, 127), 'std::uint8_t': (0, 255), 'short': (-2 ** 15, 2 ** 15 - 1),
              'unsigned': (0, 2 ** 32 - 1), 'long long': (-2 ** 63 + 1, 2 ** 63 - 1), 'std::uint64_t': (0, 2 ** 64 - 1)}
INCLUDES = ['array', 'chrono', 'complex', 'cstddef', 'cstdint', 'deque', 'list', 'map', 'optional', 'set', 'string',
            'tuple', 'utility', 'variant', 'vector']


class Struct:
    def __init__(self, name):
        self.name = name
        self.fields = []   # (name, 'offset' | 'copied')
        self.plain = True  # may be a base class: its field names are its own
        self.inherited = set()


class RandomHeader:
    def __init__(self, seed, count):
        self.random = random.Random(seed)
        self.structs, self.enums, self.lines = [], [], []
        self.spaces = ['alpha', 'alpha::inner', 'beta']
        for index in range(count):
            self.add_type(index)

    def text(self):
        head = ['#pragma once'] + [f'#include <{name}>' for name in INCLUDES]
        return '\n'.join(head + self.lines) + '\n'

    def add_type(self, index):
        space = self.random.choice(self.spaces)
        self.lines.append(f'namespace {space} {{')
        if self.random.random() < 0.15:
            self.add_enum(f'E{index}', space)
        else:
            self.add_struct(f'S{index}', space)
        self.lines.append('}')

    def add_enum(self, name, space):
        base = self.random.choice(list(UNDERLYING))
        low, high = UNDERLYING[base]
        scoped = self.random.random() < 0.5
        values = [(f'{name}_v{i}', self.random.choice([low, high, 0, 1, self.random.randint(low, high)]))
                  for i in range(self.random.randint(1, 6))]
        suffix = 'u' if low == 0 and high > 2 ** 63 else ''
        body = ', '.join(f'{n} = {v}{suffix}{"ll" if abs(v) >= 2 ** 31 and not suffix else ""}' for n, v in values)
        colon = f' : {base}' if base else ''
        self.lines.append(f'enum {"class " if scoped else ""}{name}{colon} {{ {body} }};')
        self.enums.append((f'{space}::{name}', [n for n, _ in values]))

    def value_type(self, depth=0):
        pick = self.random.random()
        known = [s.name for s in self.structs[-30:]] + [n for n, _ in self.enums[-10:]]
        if pick < 0.55 or depth > 2:
            return self.random.choice(SCALARS + ['std::string'])
        if pick < 0.75 and known:
            return '::' + self.random.choice(known)
        inner = lambda: self.value_type(depth + 1)
        number = lambda: self.random.choice(['int', 'short', 'unsigned', 'std::string'])
        return self.random.choice([
            lambda: f'std::vector<{inner()}>', lambda: f'std::deque<{inner()}>', lambda: f'std::list<{inner()}>',
            lambda: f'std::array<{inner()}, {self.random.randint(1, 4)}>', lambda: f'std::map<{number()}, {inner()}>',
            lambda: f'std::set<{number()}>', lambda: f'std::optional<{inner()}>', lambda: f'std::pair<{inner()}, {inner()}>',
            lambda: f'std::tuple<{inner()}, {inner()}>', lambda: 'std::complex<double>', lambda: 'std::chrono::milliseconds',
            lambda: f'std::variant<{inner()}, char32_t>'])()

    def add_struct(self, name, space):
        struct = Struct(f'{space}::{name}')
        bases = self.bases(struct)
        packed = not bases and self.random.random() < 0.05
        aligned = '' if packed or self.random.random() > 0.05 else f' alignas({self.random.choice([16, 32])})'
        attribute = ' __attribute__((packed))' if packed else ''
        colon = ' : ' + ', '.join(f'::{base.name}' for base in bases) if bases else ''
        self.lines.append(f'struct{attribute}{aligned} {name}{colon} {{')
        for index in range(self.random.randint(0, 8)):
            self.add_field(struct, f'{name.lower()}_{index}', packed)
        if self.random.random() < 0.2:
            self.lines.append(f'    static constexpr int kSize = {self.random.randint(1, 9)};')
        self.lines.append('};')
        struct.plain = not packed and not aligned
        struct.inherited |= {field for field, _ in struct.fields}
        self.structs.append(struct)

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
        return bases

    def add_field(self, struct, name, packed):
        pick = self.random.random()
        if packed:
            kind = self.random.choice(['char', 'double', 'short', 'int'])
            self.lines.append(f'    {kind} {name};')
            struct.fields.append((name, 'either'))
        elif pick < 0.08:
            self.lines.append(f'    {self.random.choice(["unsigned", "int", "short"])} {name} : {self.random.randint(2, 9)};')
            struct.fields.append((name, 'copied'))
        elif pick < 0.13:
            self.lines.append(f'    struct {{ int {name}_in; double {name}_side; }};')
            struct.fields += [(f'{name}_in', 'offset'), (f'{name}_side', 'offset')]
        else:
            bounds = ''.join(f'[{self.random.randint(1, 4)}]' for _ in range(self.random.choice([0, 0, 0, 0, 1, 1, 2, 3])))
            self.lines.append(f'    {self.value_type()} {name}{bounds};')
            struct.fields.append((name, 'offset'))
