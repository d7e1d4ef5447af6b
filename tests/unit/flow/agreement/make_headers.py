#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Writes <output>/{old,new}/changes.hpp, and <output>/schemas.inc with one line for each change: make_headers.py TABLE OUTPUT"""
import os
import sys

HEAD = '#pragma once\n' + ''.join(f'#include <{name}>\n' for name in
                                  ('array', 'chrono', 'map', 'optional', 'variant', 'vector'))


def main():
    table, output = sys.argv[1:]
    texts = {'old/changes.hpp': HEAD, 'new/changes.hpp': HEAD, 'schemas.inc': ''}
    with open(table, encoding='utf-8') as file:
        lines = [line for line in file if line.strip() and line[0] != '#']
    for line in lines:
        name, old, new = [part.strip() for part in line.split('|')][:3]
        texts['old/changes.hpp'] += f'namespace {name} {{ {old} }}\n'
        texts['new/changes.hpp'] += f'namespace {name} {{ {new} }}\n'
        texts['schemas.inc'] += f'&RTT::types::schemaOf<::{name}::S>,\n'
    for name, text in texts.items():
        path = os.path.join(output, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)


if __name__ == '__main__':
    main()
