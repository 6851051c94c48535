import type { Obstacle } from '@botgarten/simulation'

export type Look = 'tree' | 'rock' | 'crate' | 'ball'

/** Size, colour and weight of things as they stand in the garden: a tree and a stone stand fast, Bo can push the others. */
const things: { readonly [look in Look]: Pick<Obstacle, 'shape' | 'colour' | 'fixed'> } = {
  tree: { shape: { kind: 'circle', radius: 20 }, colour: '#7CC257', fixed: true },
  rock: { shape: { kind: 'circle', radius: 13 }, colour: '#B9AFA6', fixed: true },
  crate: { shape: { kind: 'rectangle', width: 30, height: 30 }, colour: '#DDB27C', fixed: false },
  ball: { shape: { kind: 'circle', radius: 7 }, colour: '#F7D117', fixed: false },
}

export const shapeOfLook = (look: Look): Pick<Obstacle, 'shape' | 'colour' | 'fixed' | 'look'> => ({
  ...things[look],
  look,
})
