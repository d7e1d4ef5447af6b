#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Prints the topics of an MCAP file, which its index repeats at the end: topics.py FILE"""
import struct
import sys

data = open(sys.argv[1], "rb").read()
at = struct.unpack("<Q", data[-28:-20])[0]  # the footer says where the index begins


def text(content, begin):
    size = struct.unpack_from("<I", content, begin)[0]
    return content[begin + 4:begin + 4 + size].decode(), begin + 4 + size


schemas, channels, counts = {}, {}, {}
while at < len(data) - 37:
    kind, size = struct.unpack_from("<BQ", data, at)
    content = data[at + 9:at + 9 + size]
    if kind == 3:
        schemas[struct.unpack_from("<H", content)[0]] = text(content, 2)[0]
    elif kind == 4:
        channel, schema = struct.unpack_from("<HH", content)
        channels[channel] = text(content, 4)[0], schemas[schema]
    elif kind == 11:
        counts = dict(struct.iter_unpack("<HQ", content[46:]))
    at += 9 + size
for channel, (topic, kind) in channels.items():
    print(f"{topic}: {kind}, messages: {counts.get(channel, 0)}")
