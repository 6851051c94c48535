import type { Block } from '@botgarten/blocks'
import type { Document } from '@botgarten/lab'
import {
  biasRow,
  emptyBrain,
  weightsOf,
  withWeights,
  type Brain,
  type Weights,
} from '@botgarten/learning/neural-network'
import { networks, tryingIn, type Program, type Project } from '@botgarten/programs'
import type { Pose, RobotPlacement } from '@botgarten/simulation'

/** `shared`: the same program, weights of its own · `own`: a program of its own, with weights of its own. */
export type NewRobot = 'shared' | 'own'

const noProgram: Program = { stacks: [], config: { stacks: [] } }

/** A new name that no robot, program or weight set has. */
function freshName({ world, programs, brains }: Document): string {
  const sets = Object.values(brains).flatMap((brain) => Object.keys(brain.sets))
  const things = [...world.robots, ...world.obstacles, ...world.areas, ...world.lines].map(({ id }) => id)
  const taken = new Set([...things, ...Object.keys(programs), ...sets])
  for (let number = 2; ; number++) if (!taken.has(`bo${number}`)) return `bo${number}`
}

/** Beside another one, on the side where there is more floor. */
function beside({ x, y, heading }: Pose, width: number): Pose {
  const away = 36
  return { x: x + away < width - 12 ? x + away : x - away, y, heading }
}

/** The document with one more robot, made after one that is there. Returns its id too. */
export function withRobot(
  document: Document,
  from: string,
  kind: NewRobot,
): { id: string; document: Document } {
  const id = freshName(document)
  const model = document.world.robots.find((robot) => robot.id === from) ?? document.world.robots[0]!
  const pose = beside(model.pose, document.world.size.width)
  const grown = kind === 'shared' ? withOwnWeights(document, model, id) : withOwnProgram(document, model, id)
  const own = kind === 'shared' ? { brain: id } : { brain: '', program: id }
  const robots = [...document.world.robots, { ...model, id, pose, ...own }]
  return { id, document: { ...grown, world: { ...document.world, robots } } }
}

/** The document with the first robot of another one: its program, weights and parts, under names that are free here. */
export function withGuest(document: Document, guest: Document): { id: string; document: Document } | null {
  const [first, robot] = [document.world.robots[0], guest.world.robots[0]]
  if (!first || !robot) return null
  const id = freshName(document)
  const { programs, brains, tables } = withOwnProgram(guest, robot, id)
  const program = programs[id]!
  const own = networks(program).map((net) => [net.id, brains[net.id]!] as const)
  const pose = beside(first.pose, document.world.size.width)
  const robots = [...document.world.robots, { ...robot, id, pose, program: id, brain: '' }]
  return {
    id,
    document: {
      programs: { ...document.programs, [id]: program },
      brains: { ...document.brains, ...Object.fromEntries(own) },
      ...someTables({ ...document.tables, ...tableFor(program, tables) }),
      world: { ...document.world, robots },
    },
  }
}

function withOwnWeights(document: Document, { program, brain }: RobotPlacement, set: string): Document {
  const brains: { [network: string]: Brain } = { ...document.brains }
  for (const { id } of networks(document.programs[program] ?? noProgram)) {
    const before = brains[id] ?? emptyBrain
    brains[id] = withWeights(before, weightsOf(before, brain), set)
  }
  return { ...document, brains }
}

function withOwnProgram(document: Document, { program, brain }: RobotPlacement, name: string): Document {
  const original = document.programs[program] ?? noProgram
  const idOf = ownIds(program, name)
  const brains: { [network: string]: Brain } = { ...document.brains }
  for (const { id } of networks(original)) {
    const before = brains[id] ?? emptyBrain
    const layers = before.layers.map((layer) => layer.map((one) => ({ ...one, id: idOf(one.id) })))
    brains[idOf(id)] = {
      ...before,
      layers,
      weights: renamedWeights(weightsOf(before, brain), idOf),
      sets: {},
    }
  }
  const own = Object.entries(tableFor(original, document.tables)).map(([id, table]) => [idOf(id), table])
  return {
    ...{ ...document, brains },
    ...someTables({ ...document.tables, ...(Object.fromEntries(own) as Tables) }),
    programs: { ...document.programs, [name]: renamed(original, idOf) },
  }
}

type Tables = NonNullable<Project['tables']>

/** A project without tables has no part for them. */
const someTables = (tables: Tables): Pick<Project, 'tables'> =>
  Object.keys(tables).length > 0 ? { tables } : {}

/** What a program has learned by trying, by the id of its block. */
function tableFor(program: Program, tables: Tables = {}): Tables {
  const id = tryingIn(program)?.id
  return id !== undefined && Object.hasOwn(tables, id) ? { [id]: tables[id]! } : {}
}

/** Ids of a file may be as long as ids can be. */
const longest = 150

/** The ids of one program under the name of another, however often it was copied and however long they are. */
function ownIds(from: string, name: string): (id: string) => string {
  const short = new Map<string, string>()
  return (id) => {
    const own = id.startsWith(`${from}-`) ? id.slice(from.length + 1) : id
    if (own.length <= longest) return `${name}-${own}`
    // A hidden neuron is called like its block with a number behind it, in the copy too.
    const [, block = own, number = ''] = /^(.*?)(#\d+)?$/s.exec(own) ?? []
    if (!short.has(block)) short.set(block, `${name}-${short.size + 1}-${block.slice(0, 40)}`)
    return `${short.get(block)}${number}`
  }
}

const renamedWeights = (weights: Weights, idOf: (id: string) => string): Weights =>
  Object.fromEntries(
    Object.entries(weights).map(([from, row]) => [
      from === biasRow ? from : idOf(from),
      Object.fromEntries(Object.entries(row).map(([to, weight]) => [idOf(to), weight])),
    ]),
  )

/** The document without a robot, and without what only that robot had. */
export function withoutRobot(document: Document, id: string): Document {
  const gone = document.world.robots.find((robot) => robot.id === id)
  const robots = document.world.robots.filter((robot) => robot !== gone)
  if (!gone || robots.length === 0) return document
  const usesProgram = robots.some(({ program }) => program === gone.program)
  const usesSet = gone.brain === '' || robots.some(({ brain }) => brain === gone.brain)
  const nets = usesProgram ? [] : networks(document.programs[gone.program] ?? noProgram).map((net) => net.id)
  const kept = Object.entries(document.brains).filter(([net]) => !nets.includes(net))
  const tried = usesProgram ? {} : tableFor(document.programs[gone.program] ?? noProgram, document.tables)
  const tables = Object.entries(document.tables ?? {}).filter(([id]) => !Object.hasOwn(tried, id))
  return {
    programs: usesProgram ? document.programs : without(document.programs, gone.program),
    brains: Object.fromEntries(
      kept.map(([net, brain]) => [
        net,
        usesSet ? brain : { ...brain, sets: without(brain.sets, gone.brain) },
      ]),
    ),
    ...someTables(Object.fromEntries(tables)),
    world: { ...document.world, robots },
  }
}

function without<Value>(
  all: { readonly [key: string]: Value },
  key: string,
): { readonly [key: string]: Value } {
  const { [key]: _, ...rest } = all
  return rest
}

/** The same program with other ids: two programs in one project never share a block. */
const renamed = (program: Program, idOf: (id: string) => string): Program => ({
  ...program,
  stacks: program.stacks.map((stack) => ({ ...stack, blocks: rows(stack.blocks, idOf) })),
})

const rows = (blocks: readonly Block[], idOf: (id: string) => string): Block[] =>
  blocks.map((block) => renamedBlock(block, idOf))

function renamedBlock(block: Block, idOf: (id: string) => string): Block {
  const { values, statements } = block
  return {
    ...block,
    id: idOf(block.id),
    ...(values && { values: mapped(values, (child) => renamedBlock(child, idOf)) }),
    ...(statements && { statements: mapped(statements, (children) => rows(children, idOf)) }),
  }
}

const mapped = <From, To>(all: { readonly [key: string]: From }, change: (one: From) => To) =>
  Object.fromEntries(Object.entries(all).map(([key, one]) => [key, change(one)]))
