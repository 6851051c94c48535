import { networksByUse, sceneOf, type Project } from '@botgarten/programs'
import type { World } from '@botgarten/simulation'

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

/** So many cm around Bo and what is next to it are seen. */
const around = 130

/** The part of a world around Bo and what stands nearest to it. */
export function closeUp({ size, robots, obstacles }: World) {
  const width = Math.min(size.width, around)
  const height = Math.min(size.height, around * 1.07)
  const bo = robots[0]?.pose ?? { x: size.width / 2, y: size.height / 2 }
  const away = ({ x, y }: { readonly x: number; readonly y: number }) => Math.hypot(x - bo.x, y - bo.y)
  const nearest = obstacles.map(({ pose }) => pose).toSorted((a, b) => away(a) - away(b))[0] ?? bo
  const middle = (one: number, other: number, most: number) =>
    one + Math.min(most, Math.max(-most, (other - one) / 2))
  const x = middle(bo.x, nearest.x, width / 4)
  const y = size.height - middle(bo.y, nearest.y, height / 4)
  const within = (from: number, length: number, most: number) => Math.min(most - length, Math.max(0, from))
  return {
    ...{ left: within(x - width / 2, width, size.width), top: within(y - height / 2, height, size.height) },
    ...{ width, height },
  }
}
