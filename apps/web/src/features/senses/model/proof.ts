import { triedProof, type Met, type Proof } from '@botgarten/learning/proof'
import { statesOf, type TableBrain, type TryTrace } from '@botgarten/learning/q-senses'
import { beginNight, type Night } from '@botgarten/lab/trying'
import type { Floor, World } from '@botgarten/simulation'

/** Ticks between two breaths of the page. */
const slice = 600

const breathe = (): Promise<unknown> => new Promise((done) => setTimeout(done))

export interface Learned {
  readonly world: World
  readonly floor: Floor
  readonly robot: number
  readonly table: TableBrain
}

/**
 * A value of a table, with every move that led to it: they are made again from the beginning, as fast as it goes. Null where they
 * do not come to the same, because a hand has changed something on the way.
 */
export async function proofOf({ world, floor, robot, table }: Learned, cell: number): Promise<Proof | null> {
  const night = beginNight(world, floor, table, robot)
  const met: Met[] = []
  let idle = 0
  while (night.state.table.moves < table.moves) {
    const { last } = night.state
    night.advance(1)
    const trace = night.state.last
    if (trace && trace !== last) met.push(metIn(trace, table.actions.length))
    if (++idle % slice === 0) await breathe()
  }
  const number = table.q[cell]!
  return isSame(night, cell, number) ? triedProof(triedOf(table, met), cell, number) : null
}

const isSame = ({ state }: Night, cell: number, number: number) => state.table.q[cell] === number

function triedOf(table: TableBrain, steps: readonly Met[]) {
  const [states, actions] = [statesOf(table), table.actions.length]
  return {
    first: Array.from({ length: states + 1 }, (_, state) => state * actions),
    gamma: table.gamma,
    q: Array.from({ length: states * actions }, () => 0),
    steps,
  }
}

const metIn = ({ from, action, reward, to, ends, alpha }: TryTrace, actions: number): Met => [
  ...([from, from * actions + action, reward] as const),
  ...([ends ? -1 : to, -1, alpha] as const),
]
