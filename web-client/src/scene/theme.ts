// The picture's own colours in dark and in light surroundings.
import { Color } from 'three';

export interface PictureColours {
    background: Color;
    outline: Color;
}

export const pictureColours: Record<'dark' | 'light', PictureColours> = {
    dark: { background: new Color(0x0b1018), outline: new Color(0x6b7a90) },
    light: { background: new Color(0xf2f5f9), outline: new Color(0x7d8aa0) },
};
