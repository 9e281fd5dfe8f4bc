// Textures that surfaces share: colour tables, the noise of the flow texture, and a mask that hides nothing.
import { DataTexture, LinearFilter, RedFormat, RepeatWrapping, RGBAFormat, SRGBColorSpace, UnsignedByteType } from 'three';
import { type ColourMapName, colourTable, tableSize } from './colourMap.ts';
import { flowNoise, noiseSize } from './flowNoise.ts';

export class SurfaceTextures {
    readonly noise = noiseTexture();
    readonly blank = new DataTexture(Uint8Array.of(255), 1, 1, RedFormat, UnsignedByteType);
    private readonly tables = new Map<ColourMapName, DataTexture>();

    constructor() {
        this.blank.needsUpdate = true;
    }

    colours(name: ColourMapName): DataTexture {
        const known = this.tables.get(name);
        if (known !== undefined) return known;
        const texture = new DataTexture(colourTable(name), tableSize, 1, RGBAFormat, UnsignedByteType);
        texture.colorSpace = SRGBColorSpace;
        texture.minFilter = texture.magFilter = LinearFilter;
        texture.needsUpdate = true;
        this.tables.set(name, texture);
        return texture;
    }
}

function noiseTexture(): DataTexture {
    const texture = new DataTexture(flowNoise(), noiseSize, noiseSize, RedFormat, UnsignedByteType);
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.wrapS = texture.wrapT = RepeatWrapping;
    texture.needsUpdate = true;
    return texture;
}
