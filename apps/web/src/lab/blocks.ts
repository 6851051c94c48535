import type { CardNetwork } from '@botgarten/content'
import type { Template } from '@botgarten/blocks'
import type { Activation } from '@botgarten/learning/neural-network/brain'

/** What the parts of the lab ask of the blocks. Blocks are named by their ids. */
export interface Blocks {
  moveBlocks(direction: 'undo' | 'redo', program: string): boolean | undefined
  /** What a hand has done is told now; false while it holds a block or a field is open. */
  settle(): boolean
  setFields(block: string, fields: { readonly [name: string]: string }): void
  setClosed(map: string, roads: readonly (readonly [number, number])[]): void
  /** Brings a block into sight. */
  reveal(block: string, focus?: boolean): void
  putIn(block: string): void
  /** @param wanted the network of the card; absent: the one of the toolbox */
  putNetworkIn(wanted?: CardNetwork): void
  switchOn(block: string): void
  addNeuron(network: string, layer: 'input' | 'output', neuron: Template): string | null
  /** A hidden layer before the outputs. */
  addLayer(network: string, neurons: number): void
  /** So many neurons in a hidden layer; with none the layer goes. */
  setNeurons(layer: string, neurons: number): void
  setLayerActivation(layer: string, activation: Exclude<Activation, 'softmax'>): void
}

/** Where a network is that a hand holds. */
export type Held = 'away' | 'over' | null

/** A place beside the paper onto which a network can be dropped. */
export interface NetworkDrop {
  /** null while it is not on the screen. */
  place(): Element | null
  /** A network is in the hand, or over the place; null: no more. */
  hover(held: Held): void
}
