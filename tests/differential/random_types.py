# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Random types of fields, and random enumerators."""
import math
import re

SCALARS = ['bool', 'char', 'signed char', 'unsigned char', 'short', 'unsigned short', 'int', 'unsigned', 'long',
           'unsigned long', 'long long', 'unsigned long long', 'float', 'double', 'std::size_t', 'std::int16_t',
           'long double', 'wchar_t', 'char16_t', 'char32_t', 'std::byte']
UNDERLYING = {'': (-2 ** 31, 2 ** 31 - 1), 'signed char': (-128, 127), 'std::uint8_t': (0, 255), 'short': (-2 ** 15, 2 ** 15 - 1),
              'unsigned': (0, 2 ** 32 - 1), 'long long': (-2 ** 63 + 1, 2 ** 63 - 1), 'std::uint64_t': (0, 2 ** 64 - 1),
              'char': (-128, 127), 'bool': (0, 1), 'wchar_t': (-2 ** 31, 2 ** 31 - 1), 'char16_t': (0, 2 ** 16 - 1),
              'std::size_t': (0, 2 ** 64 - 1), 'std::int_fast8_t': (-128, 127)}
INCLUDES = ['array', 'bitset', 'chrono', 'complex', 'cstddef', 'cstdint', 'deque', 'forward_list', 'list', 'map', 'memory',
            'optional', 'set', 'string', 'tuple', 'unordered_map', 'unordered_set', 'utility', 'valarray', 'variant', 'vector']


def enum_body(dice, name, base):
    """Names of the enumerators, and the text between the braces."""
    low, high = UNDERLYING[base]
    values = [(f'{name}_v{i}', dice.choice([low, high, 0, 1, dice.randint(low, high)])) for i in range(dice.randint(1, 6))]
    suffix = 'u' if low == 0 and high > 2 ** 63 else ''
    body = ', '.join(f'{n} = {v}{suffix}{"ll" if abs(v) >= 2 ** 31 and not suffix else ""}' for n, v in values)
    return [n for n, _ in values], body


class RandomTypes:
    def __init__(self, dice):
        self.random = dice
        self.structs, self.enums = [], []  # that can be elements
        self.weights = {}                  # of the structs

    def add_struct(self, name, weight):
        self.structs.append(name)
        self.weights[name] = weight

    def weight_of(self, line):
        """Not less than the bytes of the fields in it, roughly."""
        weight = 32 + sum(self.weights.get(name, 0) for name in re.findall(r'::([\w:]+)', line))
        return weight * math.prod(int(count) for pair in re.findall(r'\[(\d+)\]|, (\d+)>', line) for count in pair if count)

    def value(self, depth=0):
        pick = self.random.random()
        known = self.structs[-30:] + self.enums[-10:]
        if pick < 0.5 or depth > 2:
            return self.random.choice(SCALARS + ['std::string'])
        if pick < 0.72 and known:
            return '::' + self.random.choice(known)
        return self.random.choice([self.sequence, self.keyed, self.sum, self.other])(depth + 1)

    def key(self):
        return self.random.choice(['int', 'short', 'unsigned', 'std::string', 'bool', 'char'] +
                                  ['::' + name for name in self.enums[-3:]])

    def sequence(self, depth):
        inner = self.value(depth)
        kind = self.random.choice(['vector', 'deque', 'list', 'forward_list', 'valarray', 'array'])
        if kind == 'array':
            return f'std::array<{inner}, {self.random.randint(1, 4)}>'
        return f'std::{kind}<{inner}>'

    def keyed(self, depth):
        kind = self.random.choice(['map', 'multimap', 'unordered_map', 'unordered_multimap', 'set', 'multiset', 'unordered_set'])
        return f'std::{kind}<{self.key()}, {self.value(depth)}>' if 'map' in kind else f'std::{kind}<{self.key()}>'

    def sum(self, depth):
        inner = self.value(depth)
        return self.random.choice([f'std::optional<{inner}>', f'std::variant<std::monostate, {inner}>',
                                   f'std::variant<{inner}, std::vector<char32_t>>'])

    def other(self, depth):
        return self.random.choice([
            lambda: f'std::pair<{self.value(depth)}, {self.value(depth)}>',
            lambda: f'std::tuple<{self.value(depth)}, {self.value(depth)}, {self.value(depth)}>',
            lambda: f'std::complex<{self.random.choice(["float", "double"])}>', lambda: 'std::chrono::milliseconds',
            lambda: 'std::chrono::duration<double>', lambda: 'std::chrono::time_point<std::chrono::system_clock>',
            lambda: f'std::bitset<{self.random.choice([1, 8, 31, 64, 65, 200])}>'])()
