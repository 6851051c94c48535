import { networksByUse, sceneOf, type Project } from '@botgarten/programs'
import type { World } from '@botgarten/simulation'
import { clamp } from '#drawing/points.ts'

/** Kinds of things in which two versions of a project may differ. */
export type Kind = 'blocks' | 'knobs' | 'world' | 'robot' | 'learned' | 'name'

const robotsOf = ({ world }: Project) =>
  world.robots.map(({ id, config, program }) => ({ id, config, program }))
const blocksOf = ({ programs }: Project) =>
  Object.fromEntries(Object.entries(programs).map(([id, { stacks, config }]) => [id, { stacks, config }]))
/** Examples and practice belong to the knobs: both decide what the network does. */
const kinds: { readonly [kind in Kind]: (project: Project) => unknown } = {
  blocks: blocksOf,
  knobs: ({ brains }) => brains,
  world: ({ world }) => [sceneOf(world), world.robots.map(({ pose }) => pose)],
  robot: robotsOf,
  learned: ({ q }) => q ?? null,
  name: ({ name }) => name,
}

/** The same whatever order the keys were written in. */
const textOf = (value: unknown): string =>
  JSON.stringify(value, (_key, inner: unknown) =>
    typeof inner === 'object' && inner !== null && !Array.isArray(inner)
      ? Object.fromEntries(Object.entries(inner).sort(([one], [other]) => (one < other ? -1 : 1)))
      : inner,
  )

export interface Comparison {
  readonly different: readonly Kind[]
  readonly same: readonly Kind[]
}

/** In what two versions differ. What both lack is named in neither list. */
export function compare(one: Project, other: Project): Comparison {
  const all = Object.entries(kinds) as [Kind, (project: Project) => unknown][]
  const differs = ([, of]: (typeof all)[number]) => textOf(of(one)) !== textOf(of(other))
  const different = all.filter(differs).map(([kind]) => kind)
  const hasKnobs = [one, other].some((project) => netOf(project) !== null)
  const worthNaming: readonly Kind[] = hasKnobs ? ['blocks', 'knobs', 'world'] : ['blocks', 'world']
  return { different, same: worthNaming.filter((kind) => !different.includes(kind)) }
}

export interface SmallNet {
  readonly inputs: number
  readonly outputs: number
  readonly links: readonly { readonly from: number; readonly to: number; readonly weight: number }[]
}

/** The first network of a project as few numbers; null where it has none, or one with hidden neurons. */
export function netOf({ programs, brains, world }: Project): SmallNet | null {
  const program = programs[world.robots[0]?.program ?? '']
  const net = program && networksByUse(program)[0]
  if (!net || net.hidden.length > 0 || net.inputs.length === 0 || net.outputs.length === 0) return null
  const weights = brains[net.id]?.weights ?? {}
  const links = net.inputs.flatMap((input, from) =>
    net.outputs.map((output, to) => ({ from, to, weight: weights[input.id]?.[output.id] ?? 0 })),
  )
  return { inputs: net.inputs.length, outputs: net.outputs.length, links }
}

/** In cm: at least so much around Bo is seen, at most twice as much. */
const around = 130
/** In cm: so far Bo and the thing beside it stay away from the edge. */
const margin = 45

type Place = { readonly x: number; readonly y: number }

/** The part of a world that shows Bo and, where both fit, what stands nearest to it. */
export function closeUp({ size, robots, obstacles }: Pick<World, 'size' | 'robots' | 'obstacles'>) {
  const bo: Place = robots[0]?.pose ?? { x: size.width / 2, y: size.height / 2 }
  const away = ({ x, y }: Place) => Math.max(Math.abs(x - bo.x), Math.abs(y - bo.y))
  const nearest = obstacles.map(({ pose }) => pose).toSorted((a, b) => away(a) - away(b))[0] ?? bo
  const side = clamp(away(nearest) + 2 * margin, around, 2 * around)
  const width = Math.min(size.width, side)
  const height = Math.min(size.height, side * 1.07)
  const middle = (one: number, other: number, length: number) =>
    one + clamp((other - one) / 2, margin - length / 2, length / 2 - margin)
  const x = middle(bo.x, nearest.x, width)
  const y = size.height - middle(bo.y, nearest.y, height)
  return {
    ...{
      left: clamp(x - width / 2, 0, size.width - width),
      top: clamp(y - height / 2, 0, size.height - height),
    },
    ...{ width, height },
  }
}
