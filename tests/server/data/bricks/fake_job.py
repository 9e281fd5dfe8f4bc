#!/usr/bin/env python3
"""A job that holds no bricks and misbehaves as told: fake_job.py HOW HELLO(hex) PROGRAM STORE --socket PATH."""
import array
import mmap
import socket
import struct
import sys

how, hello, door = sys.argv[1], bytes.fromhex(sys.argv[2]), sys.argv[sys.argv.index("--socket") + 1]
MAGIC = 0x6B727742
HEAD = "<IIIIQ"  # held, checksum, brick, unused, step


def main():
    if how == "stays away":
        sys.stdin.read()
        return
    server = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    server.connect(door)
    if how == "closes before a word":
        return
    server.send(hello[:-40] if how == "cuts its first message off" else hello)
    words, rights, _, _ = server.recvmsg(24, socket.CMSG_SPACE(4))
    if len(words) < 24:
        print("refused")
        return
    _, slots, slot_bytes, _ = struct.unpack("<IIQQ", words)
    file = array.array("i", rights[0][2])[0]
    memory = mmap.mmap(file, slots * slot_bytes)
    if how == "closes after the greeting":
        return
    while asks := server.recv(1 << 16):
        for slot, brick, step in struct.iter_unpack("<IIQ", asks):
            if how == "closes when it is asked":
                return
            if how == "brings what nobody asked for":
                server.send(struct.pack("<I", slots + 7))
                continue
            if how == "answers twice":
                server.send(struct.pack("<II", slot, slot))
                continue
            if how == "cuts an answer off":
                server.send(b"\x01\x02\x03")
                continue
            if how == "says nothing":
                continue
            head = struct.pack(HEAD, MAGIC, 0, brick, 0, step)
            if how == "brings another brick":
                head = struct.pack(HEAD, MAGIC, 0x8A9136AA, brick + 1, 0, step)
            if how == "holds nothing":
                head = struct.pack(HEAD, 0, 0, brick, 0, step)
            memory[slot * slot_bytes:slot * slot_bytes + len(head)] = head
            server.send(struct.pack("<I", slot))


main()
