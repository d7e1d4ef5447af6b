# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""A program on a terminal of its own: keys in, screen out."""
import codecs
import fcntl
import os
import pty
import re
import select
import signal
import struct
import termios
import time

SEQUENCE = re.compile(r"\x1b\[(?P<numbers>[0-9;?]*)(?P<letter>[A-Za-z@])")


def set_width(terminal, width):
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 40, width, 0, 0))


class Screen:
    """What a terminal of that width shows after all that was written to it; lines that left it at the top included."""

    def __init__(self, width):
        self.width = width
        self.lines = [""]
        self.row = self.column = 0

    def put(self, letter):
        if self.column >= self.width:
            self.row, self.column = self.row + 1, 0
        while self.row >= len(self.lines):
            self.lines.append("")
        line = self.lines[self.row].ljust(self.column)
        self.lines[self.row] = line[:self.column] + letter + line[self.column + 1:]
        self.column += 1

    def sequence(self, numbers, letter):
        first = int(numbers.split(";")[0]) if numbers and numbers[0].isdigit() else None
        if letter == "A":
            self.row = max(0, self.row - (first or 1))
        elif letter == "B":
            self.row += first or 1
        elif letter == "C":
            self.column += first or 1
        elif letter == "D":
            self.column = max(0, self.column - (first or 1))
        elif letter == "G":
            self.column = (first or 1) - 1
        elif letter == "K" and self.row < len(self.lines):
            self.lines[self.row] = self.lines[self.row][:self.column]
        elif letter == "J":
            self.lines = self.lines[:self.row + 1]
            self.lines[self.row:] = [line[:self.column] for line in self.lines[self.row:]]
        elif letter == "P":
            line = self.lines[self.row]
            self.lines[self.row] = line[:self.column] + line[self.column + (first or 1):]
        elif letter == "@":
            line = self.lines[self.row]
            self.lines[self.row] = line[:self.column] + " " * (first or 1) + line[self.column:]

    def write(self, text):
        at = 0
        while at < len(text):
            found = SEQUENCE.match(text, at)
            if found:
                self.sequence(found["numbers"], found["letter"])
                at = found.end()
                continue
            letter = text[at]
            at += 1
            if letter == "\r":
                self.column = 0
            elif letter == "\n":
                self.row += 1
                while self.row >= len(self.lines):
                    self.lines.append("")
            elif letter == "\b":
                self.column = max(0, self.column - 1)
            elif letter >= " ":
                self.put(letter)

    def text(self):
        return "\n".join(line.rstrip() for line in self.lines)


class Program:
    """Runs on a pseudo-terminal; killed when it is not needed any more."""

    def __init__(self, command, directory, environment, width=100, limit=20):
        self.written = ""  # with all sequences
        self.decoder = codecs.getincrementaldecoder("utf-8")(errors="replace")  # letters come in parts
        self.limit = limit
        self.width = width
        self.status = None
        own = {k: v for k, v in os.environ.items() if not k.startswith(("ORO_", "NO_COLOR"))}
        own.update({"TERM": "xterm", "LC_ALL": "C.UTF-8"}, **environment)
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.chdir(directory)
            # As a shell starts it: Python ignores some of these, and nohup another one.
            for number in signal.SIGPIPE, signal.SIGXFSZ, signal.SIGHUP:
                signal.signal(number, signal.SIG_DFL)
            set_width(0, width)  # before the program asks for it
            os.execve(command[0], command, own)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.status is None:
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
        os.close(self.terminal)

    def resize(self, width):
        self.width = width
        set_width(self.terminal, width)

    def send(self, keys):
        os.write(self.terminal, keys.encode())

    def read(self, seconds):
        """What comes within that time, as soon as something does; False at the end."""
        ready, _, _ = select.select([self.terminal], [], [], seconds)
        if not ready:
            return True
        try:
            block = os.read(self.terminal, 65536)
        except OSError:
            return False
        self.written += self.decoder.decode(block)
        return bool(block)

    def screen(self):
        screen = Screen(self.width)
        screen.write(self.written)
        return screen.text()

    def wait(self, condition, what):
        until = time.monotonic() + self.limit
        while not condition():
            left = until - time.monotonic()
            if left <= 0 or not self.read(min(left, 0.2)):
                if condition():
                    return
                raise AssertionError(f"{what} does not come; the screen is:\n{self.screen()}")

    def wait_for(self, text):
        """Until the screen shows the text."""
        self.wait(lambda: text in self.screen(), repr(text))

    def wait_for_prompt(self, prompt):
        """Until the last line is the prompt and nothing else."""
        self.wait(lambda: self.screen().split("\n")[-1] == prompt.rstrip(), f"the prompt {prompt!r}")

    def type(self, line, prompt):
        """The line, with the return key; returns what is shown before the next prompt."""
        before = self.screen().count("\n")
        self.send(line + "\r")
        self.wait(lambda: self.screen().count("\n") > before and self.screen().split("\n")[-1] == prompt.rstrip(),
                  f"the prompt {prompt!r} after {line!r}")
        return "\n".join(self.screen().split("\n")[before + 1:-1])

    def wait_for_execution(self):
        """Until a command is executed: then the keys make signals."""
        self.wait(lambda: termios.tcgetattr(self.terminal)[3] & termios.ICANON, "the execution")

    def end(self):
        """Waits for its end; the exit status, or the negative number of the signal."""
        until = time.monotonic() + self.limit
        while time.monotonic() < until:
            self.read(0.02)
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                self.status = os.waitstatus_to_exitcode(status)
                while self.read(0):
                    if not select.select([self.terminal], [], [], 0)[0]:
                        break
                return self.status
        raise AssertionError(f"the program does not end; the screen is:\n{self.screen()}")
