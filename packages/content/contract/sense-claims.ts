import { countOf } from '@botgarten/experiments/cages'
import { tryOut } from '@botgarten/experiments/trying'
import { behave } from '@botgarten/lab/trying'
import { emptyTable, statesOf, unitOf, type TableBrain } from '@botgarten/learning/q-senses'
import { tryingIn } from '@botgarten/programs'
import { content } from '../files.ts'
import { worldAt } from '../index.ts'
import type { CageClaim, PaidClaim, TryClaim } from '../schema/planTypes.ts'

/** What the rows of a cage say: they are made by `botgarten learn try --zoo`, and its own contract test makes some of them again. */
export function rowsSay({ cage: id, those, honest }: CageClaim): CageClaim {
  const { rows } = content.senseCages.find(({ cage }) => cage.id === id)!
  const cheating = rows.bos.filter(({ cheats }) => cheats)
  const range = (name: keyof CageClaim['those']) => {
    const values = cheating.map((bo) => bo[name])
    return [name, [Math.min(...values), Math.max(...values)]] as const
  }
  const names = (some: object) => Object.keys(some) as (keyof CageClaim['those'])[]
  return {
    ...{ cage: id, cheating: countOf(rows.bos) },
    those: Object.fromEntries(names(those).map(range)),
    ...(honest && { honest: Object.fromEntries(names(honest).map((name) => [name, rows.honest![name]])) }),
    failing: rows.bos.filter(({ mended }) => mended === null).length,
  }
}

/** Learns as the card's solution does, until it drives as is meant. */
export function triedSays({ trying: id }: TryClaim): Omit<TryClaim, 'trying'> {
  const { card, world } = content.card(id)!
  const { trial, minutes } = Object.values(content.program(id, 'solution')!.programs).map((program) =>
    tryingIn(program)!,
  )[0]!
  const worlds = card.starts.map((_, start) => worldAt(world, card, start))
  const { first, curve } = tryOut(worlds, content.floorOf(world), trial, minutes)
  return { passes: first, bumps: curve.map(({ bumps }) => bumps) }
}

/** Seconds for which it is watched. */
const watched = 10

/** Whole coins a minute of a robot that only drives ahead, for one coin a unit of each pay. */
export function paidSays({ ahead, from, coins }: PaidClaim): PaidClaim['coins'] {
  const world = content.world(ahead)!
  const worlds = [{ ...world, robots: [{ ...world.robots[0]!, pose: from }] }]
  const { facts } = behave(onlyAhead, worlds, content.floorOf(world), watched).behaviour
  const paid = (kind: keyof typeof coins) => Math.round(facts[kind] / unitOf(kind)) + 0
  return Object.fromEntries((Object.keys(coins) as (keyof typeof coins)[]).map((kind) => [kind, paid(kind)]))
}

/** A table that knows nothing but ahead. */
const size = { edges: [[50]], bump: false } as const
const onlyAhead: TableBrain = {
  ...{ kind: 'table', ...size, sensors: [{ port: '2', mode: 'distance' }], hold: 15, bumpEnds: false },
  actions: [{ left: 50, right: 50 }],
  ...{ pay: [], alpha: 0.2, gamma: 0.9, rho: 0, seed: 0 },
  ...emptyTable(statesOf(size), 1),
}
