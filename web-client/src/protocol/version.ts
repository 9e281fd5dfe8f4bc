// Names the version that this client speaks. The server names its own level in `server.info`.

export const subprotocol = 'wakesurf.v1';
export const apiLevel = 5;
