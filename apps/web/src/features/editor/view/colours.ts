import type { Category } from '@botgarten/blocks'
import { mix } from '#drawing/colours.ts'

/** Block colours of visual.md 2: white text on each is at least 4.8 : 1. */
export const categoryColours: { readonly [category in Category]: string } = {
  control: '#B25A00',
  action: '#CC3F24',
  sensors: '#23804F',
  logic: '#2C6FB0',
  math: '#6F55C4',
  text: '#0B7C88',
  lists: '#3D6A75',
  variables: '#9A3F9C',
  functions: '#7B5B45',
  messages: '#5C6470',
  network: '#C2335F',
  'q-learning': '#5B7A12',
  sorting: '#8C6A00',
}

/** A block that this version does not know. */
export const unknownColour = '#6F6A66'

export const ink = '#3A2A20'
export const paper = '#FFFDF8'
/** Edges and plugs of the two layers; also the dots of their neurons. */
export const teal = '#2F9C95'
export const apricot = '#F28C45'
/** Hidden layers: they reckon, as the blocks of this colour do. */
export const violet = '#A993EA'

/** `share` of black mixed into a `#RRGGBB` colour. */
export const darker = (colour: string, share: number): string => mix(colour, '#000000', share)

/** Ground of a layer's frame. */
export const layerGround = '#8E2247'
/** And of the list of closed roads. */
export const roadsGround = '#425A0A'
