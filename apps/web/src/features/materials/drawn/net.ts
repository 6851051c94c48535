import type { Weights } from '@botgarten/learning/neural-network'
import type { NetworkOutline } from '@botgarten/programs'
import { unitScale, type Scale } from '#drawing/track.ts'
import { hiddenColumn } from '#figures/network/deep/columns.ts'
import type { DrawnNet } from './netLayout.ts'

interface Named {
  readonly id: string
}

/** Knobs go from 0 to 1, and as far beyond as the weights do. */
function scaleFor(all: readonly number[]): Scale {
  const far = Math.max(1, ...all.map((weight) => Math.ceil(Math.abs(weight))))
  return { ...unitScale, least: all.some((weight) => weight < 0) ? -far : 0, most: far }
}

/** What of a network its drawing depends on. */
export function drawnNet({ inputs, hidden, outputs }: NetworkOutline, weights: Weights): DrawnNet {
  const layers: readonly (readonly Named[])[] = [inputs, ...hidden.map(hiddenColumn), outputs]
  const links = layers
    .slice(1)
    .flatMap((ends, l) => layers[l]!.flatMap((from) => ends.map((to) => weights[from.id]?.[to.id] ?? 0)))
  const all = Object.values(weights).flatMap((row) => Object.values(row))
  return { counts: layers.map(({ length }) => length), weights: links, scale: scaleFor(all) }
}
