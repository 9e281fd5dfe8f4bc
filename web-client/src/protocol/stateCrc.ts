// The checksum of a whole mesh state, by which the client knows that it shows what the server
// computed. Independent of how the state was cut into frames. Twin: protocol/state_crc.hpp.
import { cellStride } from './cellsCode.ts';
import { crc32c } from './crc32c.ts';

export class StateCrc {
    private positions = 0;
    private cells = 0;
    private positionCount = 0;
    private cellCount = 0;

    addPositions(nodes: Int32Array): void {
        this.positions = crc32c(nodes, this.positions);
        this.positionCount += nodes.length / 3;
    }

    addCells(cells: Uint32Array): void {
        this.cells = crc32c(cells, this.cells);
        this.cellCount += cells.length / cellStride;
    }

    value(): number {
        return crc32c(Uint32Array.of(this.positionCount, this.positions, this.cellCount, this.cells));
    }
}
