#!/usr/bin/python3
"""cut.py PTY WORDS PROGRAM...: a pseudo-terminal at PTY with PROGRAM at its other end, which speaks on its standard
input and output, until a line of the page has passed that begins with WORDS: from then on nothing passes."""
import os
import subprocess
import sys
import threading
import tty


def main():
    pty, words, *program = sys.argv[1:]
    robot, page = os.openpty()
    tty.setraw(page)
    speaks = subprocess.Popen(program, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    cut = threading.Event()

    def answer():
        while said := os.read(speaks.stdout.fileno(), 4096):
            if not cut.is_set():
                os.write(robot, said)

    threading.Thread(target=answer, daemon=True).start()
    # The link comes last: whoever waits for it finds all the rest.
    os.symlink(os.ttyname(page), pty)
    rest = b""
    while True:
        *lines, rest = (rest + os.read(robot, 4096)).split(b"\n")
        for line in lines:
            if cut.is_set():
                continue
            if line.startswith(words.encode()):
                cut.set()
            os.write(speaks.stdin.fileno(), line + b"\n")


main()
