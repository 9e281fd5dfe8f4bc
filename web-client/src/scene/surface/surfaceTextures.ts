// Textures that surfaces share: colour tables, the noise of the flow texture, and a mask that hides nothing.
import {
    DataArrayTexture,
    DataTexture,
    LinearFilter,
    RedFormat,
    RepeatWrapping,
    RGBAFormat,
    RGFormat,
    SRGBColorSpace,
    UnsignedByteType,
} from 'three';
import { type ColourMapName, colourTable, tableSize } from './colourMap.ts';
import { directions, noiseSize, smearedNoise } from './smearedNoise.ts';

export class SurfaceTextures {
    readonly blank = new DataTexture(Uint8Array.of(255), 1, 1, RedFormat, UnsignedByteType);
    private readonly tables = new Map<ColourMapName, DataTexture>();
    private readonly kept = new Map<boolean, DataArrayTexture>();

    constructor() {
        this.blank.needsUpdate = true;
    }

    /** Made when it is first needed, which takes a tenth of a second. */
    noise(moving: boolean): DataArrayTexture {
        const known = this.kept.get(moving);
        if (known !== undefined) return known;
        const texture = new DataArrayTexture(smearedNoise(moving), noiseSize, noiseSize, directions + 1);
        texture.format = moving ? RGBAFormat : RGFormat;
        texture.minFilter = texture.magFilter = LinearFilter;
        texture.wrapS = texture.wrapT = RepeatWrapping;
        texture.needsUpdate = true;
        this.kept.set(moving, texture);
        return texture;
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
