# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""The services of a deployer, for rosservice and nodes in Python: what genpy makes of Eval.srv, GetPeerList.srv and
RunScript.srv, written by hand because building needs no Python."""
import hashlib
import struct

import genpy

_length = struct.Struct("<I")


def _write_text(buff, text):
    data = text if isinstance(text, bytes) else text.encode("utf-8")
    buff.write(_length.pack(len(data)) + data)


def _read_length(data, at):
    return _length.unpack_from(data, at)[0], at + _length.size


def _read_text(data, at):
    size, at = _read_length(data, at)
    if at + size > len(data):
        raise struct.error("a text of %d bytes is longer than its message" % size)
    return data[at:at + size].decode("utf-8", "replace"), at + size


def _write(buff, kind, value):
    if kind == "bool":
        buff.write(b"\1" if value else b"\0")
    elif kind == "string":
        _write_text(buff, value)
    else:
        buff.write(_length.pack(len(value)))
        for text in value:
            _write_text(buff, text)


def _read(data, kind):
    if kind == "bool":
        return struct.unpack_from("<B", data)[0] != 0
    if kind == "string":
        return _read_text(data, 0)[0]
    count, at = _read_length(data, 0)
    texts = []
    for _ in range(count):
        text, at = _read_text(data, at)
        texts.append(text)
    return texts


class _Half(genpy.Message):
    """A request or a response: one field, or none."""
    __slots__ = []
    _slot_types = []
    _has_header = False

    def __init__(self, *args, **kwds):
        super().__init__(*args, **kwds)
        for name, kind in zip(self.__slots__, self._slot_types):
            if getattr(self, name, None) is None:
                setattr(self, name, {"bool": False, "string": ""}.get(kind, []))

    def _get_types(self):
        return self._slot_types

    def serialize(self, buff):
        for name, kind in zip(self.__slots__, self._slot_types):
            try:
                _write(buff, kind, getattr(self, name))
            except (AttributeError, TypeError, struct.error):
                self._check_types()
                raise

    def deserialize(self, data):
        try:
            for name, kind in zip(self.__slots__, self._slot_types):
                setattr(self, name, _read(data, kind))
        except struct.error as error:
            raise genpy.DeserializationError(error)
        return self

    def serialize_numpy(self, buff, numpy):
        self.serialize(buff)

    def deserialize_numpy(self, data, numpy):
        return self.deserialize(data)


def _half(name, line):
    kind, field = line.split() if line else ("", "")
    return type(name, (_Half,), {
        "__module__": __name__,
        "__slots__": [field] if line else [],
        "_slot_types": [kind] if line else [],
        "_type": "rtt_ros_msgs/" + name,
        "_full_text": line + "\n",
        "_md5sum": hashlib.md5(line.encode()).hexdigest(),
    })


def _service(name, request, response):
    halves = _half(name + "Request", request), _half(name + "Response", response)
    service = type(name, (), {
        "__module__": __name__,
        "_type": "rtt_ros_msgs/" + name,
        "_request_class": halves[0],
        "_response_class": halves[1],
        "_md5sum": hashlib.md5((request + response).encode()).hexdigest(),
    })
    return (service,) + halves


Eval, EvalRequest, EvalResponse = _service("Eval", "string code", "bool success")
GetPeerList, GetPeerListRequest, GetPeerListResponse = _service("GetPeerList", "", "string[] peers")
RunScript, RunScriptRequest, RunScriptResponse = _service("RunScript", "string file_path", "bool success")
