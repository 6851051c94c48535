import { atan2 } from '@botgarten/numbers'
import type { Course } from '@botgarten/learning/q-learning'
import type { Learned } from '@botgarten/programs/python'
import { distance } from './point.ts'
import type { MapFile } from './types.ts'
import { placeOf } from './way.ts'

type Lesson = NonNullable<Learned['lesson']>

/**
 * What a robot needs to go on learning on a floor with stations; undefined where a floor cannot be like the map: where a
 * move may slip or two roads lead to the same station, where no road leaves the start, and for the rules of the study.
 */
export function lessonOf({ learner }: Course, map: MapFile): Lesson | undefined {
  const { world, settings } = learner
  const { first, meant, isSlippery, start } = world
  const actionsOf = (state: number) => span(first[state]!, first[state + 1]!)
  const isTwice = span(0, world.states).some((state) => {
    const targets = actionsOf(state).map((action) => meant[action]!)
    return new Set(targets).size < targets.length
  })
  const isStudy = settings.rules === 'study' || settings.algorithm !== 'q'
  if (isSlippery || isTwice || isStudy || actionsOf(start).length === 0) return undefined
  const roads = span(0, world.states)
    .filter((from) => actionsOf(from).length > 0)
    .map((from) => {
      const moves = actionsOf(from).map((action) => {
        const [to, reward] = [meant[action]!, world.reward[action]!]
        return [to, { ...legOf(map, from, to), reward }] as const
      })
      return [from, Object.fromEntries(moves)] as const
    })
  const ends = span(0, world.states).filter(
    (state) => world.terminal[state] === 1 || !actionsOf(state).length,
  )
  return {
    states: world.states,
    start,
    ends,
    open: [...world.open],
    roads: Object.fromEntries(roads),
    settings,
  }
}

const span = (from: number, to: number) => Array.from({ length: to - from }, (_, k) => from + k)

/** Straight from the middle of a station to that of the next. `direction`: degrees clockwise from the right. */
function legOf(map: MapFile, from: number, to: number) {
  const [a, b] = [placeOf(map, from), placeOf(map, to)]
  const direction = (-atan2(b.y - a.y, b.x - a.x) * 180) / Math.PI
  return { direction: (direction + 360) % 360, length: distance(a, b) }
}
