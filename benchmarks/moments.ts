// Runs in Node and, bundled, inside a page: ten minutes of a run, and the way back to moments of it.
import { createLab, type Document, type Lab } from '@botgarten/lab'
import { paintFloor } from '@botgarten/simulation'
import { behaviours } from '../e2e/runs/programs.ts'
import { pushingWorld } from '../e2e/runs/worlds.ts'

const minute = 3600
const end = 10 * minute

export interface Moments {
  readonly name: string
  /** Milliseconds for every moment that was gone to. */
  readonly took: readonly number[]
  /** At how many of them the hash was that of the original. */
  readonly equal: number
}

/** Numbers 0..1, the same everywhere. */
function* numbers(seed: number) {
  for (let state = seed; ;) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    yield state / 2 ** 32
  }
}

/** A hand moves a thing every twelve seconds and turns a knob every three. */
function hands(lab: Lab, tick: number) {
  const [network] = Object.keys(lab.document().brains)
  const { layers } = lab.document().brains[network ?? ''] ?? { layers: [] }
  const [from, to] = [layers[0]?.[0]?.id, layers.at(-1)?.[0]?.id]
  const turned = ((tick / 180) % 7) / 10
  if (network && from && to && tick % 180 === 0) lab.setWeight(network, from, to, turned)
  if (tick % 720 === 0) lab.place('thing2', { x: 40 + ((tick / 7) % 220), y: 60, heading: 0 })
}

const crowd: { readonly name: string; readonly document: Document } = {
  name: 'network in a crowd of eight',
  document: { ...behaviours.followsEyes(1), world: pushingWorld(0) },
}
const measuring: Document = { ...behaviours.measures(2), world: pushingWorld(2) }

/** Nothing but one robot on the same floor. */
const alone: Document = { ...crowd.document, world: { ...crowd.document.world, obstacles: [] } }

/** So many robots with the same program, each among the others. */
function robots(count: number): Document {
  const { world } = crowd.document
  const [bo] = world.robots
  const all = Array.from({ length: count }, (_, index) => ({
    ...bo!,
    id: index === 0 ? bo!.id : `bo${index + 1}`,
    pose: { x: 40 + 60 * (index % 4), y: 60 + 60 * Math.floor(index / 4), heading: 45 * index },
  }))
  return { ...alone, world: { ...world, obstacles: [], robots: all } }
}

export interface Steps {
  readonly name: string
  /** Milliseconds of a step of simulation and program, the mean of each simulated minute. */
  readonly perStep: readonly number[]
}

/** What a step of simulation and program takes, minute after minute. */
export function steps(minutes: number): Steps[] {
  return [
    { name: 'one robot alone', document: alone },
    crowd,
    { name: 'four robots', document: robots(4) },
  ].map(({ name, document }) => {
    const lab = createLab()
    lab.load(document, paintFloor(document.world), { seed: 11, checks: [] })
    lab.start()
    const perStep = Array.from({ length: minutes }, () => {
      const before = performance.now()
      for (let tick = 0; tick < minute; tick += 1) lab.advance(1)
      return (performance.now() - before) / minute
    })
    return { name, perStep }
  })
}

/** What a child with a network in a crowd of eight things, and one that measures its ways, does in ten minutes. */
export function moments(count: number): Moments[] {
  return [crowd, { name: 'measured ways in a crowd', document: measuring }].map(({ name, document }) => {
    const lab = createLab()
    lab.load(document, paintFloor(document.world), { seed: 11, checks: [] })
    lab.start()
    const draw = numbers(7)
    const wanted = Array.from({ length: count }, () => Math.floor(draw.next().value! * end))
    const hashes = new Map<number, string>()
    const asked = new Set(wanted)
    for (let tick = 0; tick < end; tick += 1) {
      if (asked.has(tick)) hashes.set(tick, lab.hash())
      hands(lab, tick)
      lab.advance(1)
    }
    const took: number[] = []
    let equal = 0
    for (const tick of wanted) {
      const before = performance.now()
      lab.goTo(tick)
      lab.view()
      took.push(performance.now() - before)
      if (lab.hash() === hashes.get(tick)) equal += 1
    }
    return { name, took, equal }
  })
}
