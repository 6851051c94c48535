import { createLab, type Document } from '@botgarten/lab'
import { noExamples, type Examples } from '@botgarten/learning/neural-network/examples'
import { networks, writeProjectFile, type Program } from '@botgarten/programs'
import { examplesCsv } from '@botgarten/programs/examples'
import { content } from '@botgarten/content/files'
import { cardDocument } from '@botgarten/content'
import { TICKS_PER_SECOND } from '@botgarten/simulation'
import type { Command } from '../commands.ts'
import { CallError } from '../errors.ts'
import { write } from '../files.ts'
import { floorOf } from '../floor.ts'
import { numberIn, options, wholeNumberIn } from '../options.ts'
import { readProjectFile } from '../project-file.ts'
import { message } from '../words.ts'
import { blockIn, sourceOf, type Source } from './source.ts'

const known = {
  program: { type: 'string' },
  solution: { type: 'boolean' },
  brain: { type: 'string' },
  start: { type: 'string' },
  seconds: { type: 'string' },
  rate: { type: 'string' },
  seed: { type: 'string' },
  csv: { type: 'string' },
  out: { type: 'string' },
  json: { type: 'boolean' },
} as const

/** `botgarten record CARD|FILE …`: a program drives, and what its network reads and what it does become examples. */
export const record: Command = { options: known, execute: recordOnce }

type Values = ReturnType<typeof options<typeof known>>['values']

function recordOnce(args: string[]): string {
  const { values, positionals } = options(args, known)
  const [what, ...more] = positionals
  if (!what || more.length > 0) throw new CallError('call.recordWhat')
  if (values.solution && values.program !== undefined) throw new CallError('call.solutionOrProgram')
  const source = sourceOf(what, { brain: values.brain })
  const seconds = numberIn('seconds', values.seconds, 20, 0, 3600)
  const seed = wholeNumberIn('seed', values.seed, 1, 0, 4_294_967_295)
  const rate = wholeNumberIn('rate', values.rate, 10, 1, 60)
  const { examples, hash } = written(documentOf(source, what, values), source, { seconds, seed, rate })
  if (values.csv !== undefined) write(values.csv, examplesCsv(examples, true))
  if (values.out !== undefined) save(values.out, source, examples)
  const report = { rows: examples.rows.length, seconds, seed, hash }
  return values.json ? JSON.stringify(report) : message('examples.recorded', report)
}

/** The world from a start of the card; the program that drives, with the network beside it where it has none of this name. */
function documentOf({ project, card, program, network }: Source, what: string, values: Values): Document {
  const start = wholeNumberIn('start', values.start, 0, 0, (card?.card.starts.length ?? 1) - 1)
  const driver = driverOf(what, values) ?? project.programs[program]!
  const own = blockIn(project.programs[program]!, network.id)
  const has = networks(driver).some(({ id }) => id === network.id)
  const stacks = has || !own ? driver.stacks : [...driver.stacks, { x: 0, y: 0, blocks: [own] }]
  const programs = { ...project.programs, [program]: { ...driver, stacks } }
  const brains = values.solution ? content.program(what, 'solution')!.brains : project.brains
  const document = { ...project, programs, brains }
  return card ? cardDocument(card.world, card.card, document, start) : document
}

function driverOf(what: string, { solution, program }: Values): Program | undefined {
  if (solution && !content.card(what)) throw new CallError('call.ofACard')
  if (solution) return Object.values(content.program(what, 'solution')!.programs)[0]
  return program === undefined ? undefined : Object.values(readProjectFile(program).programs)[0]
}

function written(
  document: Document,
  { network, program, project }: Source,
  { seconds, seed, rate }: { readonly seconds: number; readonly seed: number; readonly rate: number },
): { readonly examples: Examples; readonly hash: string } {
  const robot = document.world.robots.find((one) => one.program === program)!
  const lab = createLab()
  lab.load(document, floorOf(document.world, project.assets), { seed, checks: [] })
  const drive = { id: 'program-1', by: 'program', seed } as const
  lab.record({ robot: robot.id, network: network.id, drive, every: Math.round(TICKS_PER_SECOND / rate) })
  lab.start()
  lab.advance(Math.round(seconds * TICKS_PER_SECOND))
  const ids = (neurons: Source['network']['inputs']) => neurons.map(({ id }) => id)
  const none = noExamples(ids(network.inputs), ids(network.outputs))
  return { examples: lab.document().brains[network.id]?.examples ?? none, hash: lab.hash() }
}

function save(path: string, { project, network, brain }: Source, examples: Examples): void {
  write(
    path,
    writeProjectFile({ ...project, brains: { ...project.brains, [network.id]: { ...brain, examples } } }),
  )
}
