#!/usr/bin/python3
"""board.py PTY [--off-usb]: this computer, as the browser sees it, has an Arduino Uno (or a port off USB) on
/dev/ttyACM0 whose bytes are those of the pseudo-terminal PTY. Start it with
LD_PRELOAD=libumockdev-preload.so.0; it prints the folder for UMOCKDEV_DIR, then takes `plug` and `unplug` of
what is on USB."""
import errno
import os
import struct
import sys

import gi

gi.require_version("UMockdev", "1.0")
from gi.repository import GLib, UMockdev

TIOCEXCL, TIOCMGET, TIOCMBIS, TIOCMBIC, TIOCMSET = 0x540C, 0x5415, 0x5416, 0x5417, 0x5418
DTR, RTS, CTS, CAR, DSR = 0x2, 0x4, 0x20, 0x40, 0x100

USB = "/sys/devices/pci0000:00/0000:00:14.0/usb1/1-1/1-1:1.0/tty/ttyACM0"


def description(off_usb):
    if off_usb:
        return (
            "P: /devices/platform/serial8250/tty/ttyACM0\nN: ttyACM0\nE: DEVNAME=/dev/ttyACM0\n"
            "E: SUBSYSTEM=tty\nE: MAJOR=4\nE: MINOR=64\nA: dev=4:64\n"
        )
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "uno.umockdev")) as file:
        return file.read()


class Lines:
    """The modem's lines: opening a port fails where nobody answers for them. And who has the port for itself: to
    root, the kernel would give it twice."""

    def __init__(self):
        self.out = DTR | RTS
        self.owner = None

    def handle(self, _, client):
        request = client.get_request()
        if request == TIOCMGET:
            client.get_arg().resolve(0, 4).update(0, struct.pack("I", self.out | CTS | CAR | DSR))
        elif request in (TIOCMBIS, TIOCMBIC, TIOCMSET):
            (bits,) = struct.unpack("I", bytes(client.get_arg().resolve(0, 4).retrieve()))
            now = {TIOCMBIS: self.out | bits, TIOCMBIC: self.out & ~bits, TIOCMSET: bits}
            self.out = now[request] & (DTR | RTS)
        elif request == TIOCEXCL and self.is_taken():
            client.complete(-1, errno.EBUSY)
            return True
        else:
            if request == TIOCEXCL:
                self.owner = client
                self.out = DTR | RTS
            client.complete(*client.execute())
            return True
        client.complete(0, 0)
        return True

    def is_taken(self):
        return self.owner is not None and self.owner.get_connected()


def main():
    pty, off_usb = sys.argv[1], "--off-usb" in sys.argv
    testbed = UMockdev.Testbed.new()
    testbed.add_from_string(description(off_usb))
    node = testbed.get_root_dir() + "/dev/ttyACM0"
    os.unlink(node)
    # The link, not what it leads to: a robot that comes back has another terminal.
    os.symlink(pty, node)
    lines = Lines()
    ioctl = UMockdev.IoctlBase.new()
    ioctl.connect("handle-ioctl", lines.handle)
    testbed.attach_ioctl("/dev/ttyACM0", ioctl)
    print(testbed.get_root_dir(), flush=True)

    def told(*_):
        word = sys.stdin.readline().strip()
        if word in ("plug", "unplug"):
            testbed.uevent(USB, "add" if word == "plug" else "remove")
        elif not word:
            os._exit(0)
        print("done " + word, flush=True)
        return True

    GLib.io_add_watch(0, GLib.IO_IN, told)
    GLib.MainLoop().run()


main()
