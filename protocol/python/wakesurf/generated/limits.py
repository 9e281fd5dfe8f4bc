"""Limits of the server that the client keeps to.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
PROBE_POINTS = 4096  # of one call
MESSAGE_BYTES = 65536  # that the server takes
