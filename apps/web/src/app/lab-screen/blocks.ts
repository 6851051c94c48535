import type { Paper } from '#features/editor/layers.ts'

/** What the parts of the lab ask of the blocks. Blocks are named by their ids. */
export interface Blocks {
  moveBlocks(direction: 'undo' | 'redo', program: string): boolean | undefined
  setFields(block: string, fields: { readonly [name: string]: string }): void
  setClosed(map: string, roads: readonly (readonly [number, number])[]): void
  /** Brings a block into sight. */
  reveal(block: string, focus?: boolean): void
  paper(): Paper | null
  putIn(block: string): void
  putNetworkIn(): void
  switchOn(block: string): void
  addNeuron(network: string, layer: 'input' | 'output'): string | null
}
