# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""A deployment that answers as a test wants: for what a real one never does."""
import base64
import hashlib
import json
import os
import pathlib
import socket
import struct
import threading

GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"
TEXT, CLOSE, PING, PONG = 1, 8, 9, 10


def frame(payload, opcode=TEXT):
    size = len(payload)
    if size < 126:
        head = struct.pack("!BB", 0x80 | opcode, size)
    elif size < 65536:
        head = struct.pack("!BBH", 0x80 | opcode, 126, size)
    else:
        head = struct.pack("!BBQ", 0x80 | opcode, 127, size)
    return head + payload


class Client:
    """The connection of one client."""

    def __init__(self, connection):
        self.connection = connection
        self.stream = connection.makefile("rb")
        self.head = ""

    def shake_hands(self, protocol):
        lines = []
        while True:
            line = self.stream.readline().decode().strip()
            if not line:
                break
            lines.append(line)
        self.head = "\n".join(lines)
        key = next(line.split(": ")[1] for line in lines if line.lower().startswith("sec-websocket-key"))
        accept = base64.b64encode(hashlib.sha1((key + GUID).encode()).digest()).decode()
        self.connection.sendall(("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                                 f"Sec-WebSocket-Accept: {accept}\r\n"
                                 f"Sec-WebSocket-Protocol: {protocol}\r\n\r\n").encode())

    def read(self):
        """The next request; None at the end."""
        while True:
            head = self.stream.read(2)
            if len(head) < 2:
                return None
            opcode, size = head[0] & 15, head[1] & 127
            if size >= 126:
                size = int.from_bytes(self.stream.read(2 if size == 126 else 8), "big")
            mask = self.stream.read(4)
            payload = bytes(b ^ mask[i % 4] for i, b in enumerate(self.stream.read(size)))
            if opcode == TEXT:
                return json.loads(payload)
            if opcode == CLOSE:
                return None

    def send(self, message):
        self.raw(frame(json.dumps(message).encode()))

    def raw(self, data):
        self.connection.sendall(data)

    def answer(self, request, result):
        self.send({"op": "oro.answer", "id": request["id"], "result": result})

    def refuse(self, request, code, message):
        self.send({"op": "oro.error", "id": request["id"], "code": code, "message": message})


class FakeDeployment:
    """Calls handle(client, request) for each request; false ends the connection. Its process is this one."""

    def __init__(self, folder, handle, name="fake", protocol="oro.v1", pid=None):
        self.folder = pathlib.Path(folder) / "oroforge"
        self.folder.mkdir(mode=0o700, exist_ok=True)
        self.path = self.folder / f"{pid or os.getpid()}-{name}.sock"
        self.handle, self.protocol, self.name = handle, protocol, name
        self.requests = []
        self.heads = []
        self.listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self.listener.bind(str(self.path))
        self.listener.listen(16)
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        while True:
            try:
                connection, _ = self.listener.accept()
            except OSError:
                return
            threading.Thread(target=self.talk, args=(connection,), daemon=True).start()

    def talk(self, connection):
        try:
            with connection:
                client = Client(connection)
                client.shake_hands(self.protocol)
                self.heads.append(client.head)
                while True:
                    request = client.read()
                    if request is None:
                        return
                    self.requests.append(request)
                    if self.handle(client, request) is False:
                        return
        except (OSError, StopIteration):
            pass  # the client has gone

    def close(self):
        if self.listener.fileno() < 0:
            return
        self.listener.shutdown(socket.SHUT_RDWR)
        self.listener.close()
        if self.path.exists():
            self.path.unlink()
