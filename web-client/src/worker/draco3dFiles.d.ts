// The decoder alone; the package's main entry would also bring the encoder.
declare module 'draco3d/draco_decoder_nodejs.js' {
    import type { DecoderModule } from 'draco3d';
    export default function createDecoderModule(options: { wasmBinary: ArrayBuffer }): Promise<DecoderModule>;
}
