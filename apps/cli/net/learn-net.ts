import { pruneWeights } from '@botgarten/learning/neural-network/brain'
import { beginExercise, practiceChoice, type Exercise } from '@botgarten/learning/neural-network/examples'
import { percentOff, type Settings } from '@botgarten/learning/neural-network/train'
import { netProof, type Proof } from '@botgarten/learning/proof'
import { refusalOf, writeProjectFile } from '@botgarten/programs'
import { withHidden } from '@botgarten/programs/examples'
import type { Command } from '../commands.ts'
import { CallError, FileError } from '../errors.ts'
import { write } from '../files.ts'
import { seedOf } from '../learn-options.ts'
import { writeNotebook } from '../notebook.ts'
import { note } from '../notes.ts'
import { options, wholeNumberIn } from '../options.ts'
import { message } from '../words.ts'
import { beginningOf, hiddenOf, known, settingsOf, type Values } from './options.ts'
import { practised } from './practised.ts'
import { emptyFor, readExamples } from './read-examples.ts'
import { networkIn, sourceOf, type Source } from './source.ts'
import { startsPassed } from './starts.ts'

/** `botgarten learn net CARD|FILE …`: a network practises its examples. */
export const net: Command = { options: known, execute: learnNet }

const mostSeeds = 1000

function learnNet(args: string[]): string {
  const { values, positionals } = options(args, known)
  const [what, ...more] = positionals
  if (!what || more.length > 0) throw new CallError('call.netWhat')
  const source = shaped(sourceOf(what, values), values)
  if (values.seeds === undefined) return one(source, values)
  if (values.out !== undefined) throw new CallError('call.outOfOne')
  if (values.notebook !== undefined) throw new CallError('call.notebookOfOne')
  return several(source, values)
}

/** The source with the hidden layers of the call, and no weights of links that it had without them. */
function shaped(source: Source, { hidden }: Values): Source {
  if (hidden === undefined) return source
  const { project, program, network, card } = source
  const changed = withHidden(project.programs[program]!, network.id, hiddenOf(hidden))
  const programs = { ...project.programs, [program]: changed }
  const found = networkIn({ ...project, programs }, network.id)
  const brain = { ...found.brain, weights: pruneWeights(found.brain, found.brain.weights) }
  return { ...found, brain, card }
}

function exerciseOf(source: Source, values: Values & { readonly examples?: string }, seed: number): Exercise {
  const { network, brain } = source
  const examples =
    values.examples === undefined
      ? (brain.examples ?? emptyFor(network))
      : readExamples(values.examples, network)
  // A solution has practised already: it does so again from where it began.
  const weights = (values.solution && brain.practice?.start) || brain.weights
  return {
    ...{ id: network.id, layers: brain.layers, weights, examples, seed },
    ...beginningOf(values, source),
  }
}

function one(
  source: Source,
  values: Values & {
    readonly examples?: string
    readonly seed?: string
    readonly out?: string
    readonly notebook?: string
  },
): string {
  const { project, card, network, brain } = source
  const seed = values.seed === undefined ? practiceChoice(brain).seed : seedOf(values)
  const exercise = exerciseOf(source, values, seed)
  const settings = settingsOf(values, brain)
  const done = practised(exercise, settings, brain)
  const { practice, curve, weights, last, hash, prepared, sleeping, byHeart } = done
  notesOf(done)
  if (values.out !== undefined) save(values.out, source, done.brain)
  if (values.notebook !== undefined) writeNotebook(values.notebook, proofOf(done, exercise, settings))
  const report = {
    ...{ rounds: practice.round, practised: last.practised, keptBack: last.kept, weights, curve },
    starts: startsPassed(project, card, network.id, done.brain),
    ...{ hash, ended: practice.ended!.kind, examples: prepared.practised.length, byHeart, sleeping },
  }
  return values.json ? JSON.stringify(report) : sentenceOf(report, practice.net.shares)
}

function save(path: string, { project, network }: Source, brain: Source['brain']): void {
  const practisedProject = { ...project, brains: { ...project.brains, [network.id]: brain } }
  if (refusalOf(practisedProject))
    throw new FileError('file.unwritable', { path, why: message('cause.tooBig', { most: 5 }) })
  write(path, writeProjectFile(practisedProject))
}

type Done = ReturnType<typeof practised>

/** It practises once more, to the round that it ended with. */
function proofOf({ prepared, practice }: Done, exercise: Exercise, settings: Settings): Proof {
  const { ended, round } = practice
  const rounds = ended?.kind === 'noBetter' ? ended.best : round
  const begun = beginExercise(prepared, { ...settings, rounds: rounds + 1, patience: 0 }, exercise)
  const making = netProof(begun, rounds)
  for (;;) {
    const { done, value } = making.next()
    if (done) return value
  }
}

/** What is said beside the result. */
function notesOf({ prepared, practice, sleeping, byHeart }: Done): void {
  if (prepared.shaken) note(message('examples.shaken'))
  if (prepared.asks) note(message('examples.asks'))
  if (prepared.gaps > 0) note(message('examples.gaps', { count: prepared.gaps }))
  if (sleeping.length > 0) note(message('examples.asleep', { neurons: sleeping.join(', ') }))
  if (byHeart !== null) note(message('examples.byHeart', { round: byHeart }))
  const { ended } = practice
  if (ended?.kind === 'ranAway') note(message('examples.ranAway', { round: ended.round }))
  if (ended?.kind === 'noBetter') note(message('examples.noBetter', { round: ended.best }))
}

interface Report {
  readonly rounds: number
  readonly practised: number
  readonly keptBack: number | null
  readonly starts: { readonly passed: number; readonly of: number }
  readonly examples: number
}

function sentenceOf(
  { rounds, practised: loss, keptBack, starts, examples }: Report,
  shares: boolean,
): string {
  const said = (value: number) =>
    shares
      ? message('examples.entropy', { value: value.toFixed(4) })
      : message('examples.off', { percent: percentOff(value).toFixed(1) })
  const error =
    keptBack === null ? said(loss) : message('examples.both', { practised: said(loss), kept: said(keptBack) })
  const after = message('examples.after', { examples, rounds, error })
  return starts.of === 0 ? after : message('examples.passed', { after, ...starts })
}

function several(
  source: Source,
  values: Values & {
    readonly examples?: string
    readonly seed?: string
    readonly seeds?: string
    readonly json?: boolean
  },
): string {
  const { project, card, network, brain } = source
  const settings = settingsOf(values, brain)
  const first = seedOf(values)
  const exercise = exerciseOf(source, values, first)
  const count = wholeNumberIn('seeds', values.seeds, 1, 1, mostSeeds)
  const seeds = Array.from({ length: count }, (_, k) => {
    const done = practised({ ...exercise, seed: first + k }, settings, brain)
    const starts = startsPassed(project, card, network.id, done.brain)
    return { seed: first + k, practised: done.last.practised, keptBack: done.last.kept, starts }
  })
  if (values.json) return JSON.stringify({ seeds })
  const whole = seeds.filter(({ starts }) => starts.of > 0 && starts.passed === starts.of).length
  return message('examples.seeds', { count, whole })
}
