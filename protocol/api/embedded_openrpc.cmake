# Writes OUTPUT, the source of the text that openrpc.cpp puts the version into: cmake -DINPUT=generated/openrpc.json -DOUTPUT= -P.
# As numbers, because a literal of this length is more than a compiler need take.
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
file(WRITE ${OUTPUT} "namespace wakesurf::protocol {
extern const unsigned char openrpc_text[];
extern const unsigned long openrpc_size;
const unsigned char openrpc_text[]{${bytes}};
const unsigned long openrpc_size = sizeof openrpc_text;
} // namespace wakesurf::protocol
")
