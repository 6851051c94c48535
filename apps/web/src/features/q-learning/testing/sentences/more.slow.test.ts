import { addBlocks, knowMaps } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { content } from '@botgarten/content/files'
import type { ExampleFinding } from '@botgarten/learning/neural-network/examples'
import { tableOf } from '@botgarten/messages/folder'
import { check } from '@botgarten/programs'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import { wordsOf } from '#app/lab-screen/findings.ts'
import { idleNote } from '#features/network/idle-note.ts'
import type { Training } from '#features/training/training.svelte.ts'
import type { ShownRow } from '#features/training/model/table.ts'
import { offWords } from '#features/training/view/example.ts'
import { curveWords, errorWords, number, rowName, signed } from '#features/training/view/messages.ts'
import { questionOf } from '#features/training/view/questions.ts'
import { level, levels } from '#figures/network/level.svelte.ts'
import type { Neuron } from '#figures/network/neurons.ts'
import { language } from '#words/language.svelte.ts'
import { message } from '#words/message.ts'
import { faultsIn } from './faults.ts'

addBlocks(learning)
addBlocks(expert)
knowMaps(content)

const faulty = (sentences: readonly string[], locale: string) =>
  [...new Set(sentences)].flatMap((text) => faultsIn(text, locale).map((fault) => `${fault}: ${text}`))

// ---- findings in blocks ----

/** Findings of all programs of the cards, in their robot and in one without any part. */
const findings = content.cards.flatMap(({ id }) => {
  const { world } = content.card(id)!
  const { config } = world.robots[0]!
  const files = ['start', 'solution', ...content.wrongAnswers(id).map((name) => `wrong/${name}`)]
  const moved = Object.fromEntries(Object.entries(config.sensors).map(([, sensor], at) => [at + 1, sensor]))
  const turned = Object.fromEntries(
    Object.entries(config.sensors).map(([, sensor], at, all) => [all.length - at, sensor]),
  )
  const robots = [config, ...[{}, moved, turned].map((sensors) => ({ ...config, sensors }))]
  return files.flatMap((file) =>
    Object.values(content.program(id, file)!.programs).flatMap((program) =>
      robots.flatMap((robot) => check(program, robot)),
    ),
  )
})

// ---- numbers as the screens format them ----

const counts = [0, 1, 2, 21, 1000]
const values = [0, 1, -1, 0.5, -0.25, 1234.5, 1 / 3, -1e-9]
const losses = [0, 1e-12, 0.0004, 0.0123, 0.25, 1]

const neuron = (id: string, label: string): Neuron => ({
  ...{ id, label, place: null, name: label, colour: '#000000', missing: false },
})
const layers = {
  inputs: [neuron('a', 'A'), neuron('b', 'B')],
  outputs: [neuron('c', 'C'), neuron('d', 'D')],
} as unknown as Training

const questions: readonly ExampleFinding[] = [
  ...(['contradiction', 'blind'] as const).flatMap((kind) =>
    [[4], [4, 7], [4, 7, 9, 30]].map((others) => ({ kind, row: 0, others })),
  ),
  { kind: 'oddOne', row: 11 },
  ...[
    [0, 9],
    [1, 8],
    [40, 1],
  ].map(([left, right]) => ({ kind: 'oneSided' as const, left: left!, right: right! })),
  { kind: 'neverSeen', readings: [0, 99.6] },
  ...[true, false].flatMap((isInput) =>
    values.map((value) => ({ kind: 'allAlike' as const, column: isInput ? 'a' : 'd', isInput, value })),
  ),
  { kind: 'sleeping', rows: [1] },
  ...[true, false].flatMap((isMirrored) =>
    [1, 2, 30].map((rows) => ({ kind: 'few' as const, rows, isMirrored, knobs: 4 })),
  ),
]

const row = (number: number, inputs: ShownRow['inputs']): ShownRow =>
  ({ at: number - 1, number, on: true, inputs, outputs: [-100, 33.4], pose: null }) as unknown as ShownRow

function practiceSentences(): readonly string[] {
  const curve = (kept: number | null) =>
    losses.map((loss, at) => ({ round: at * 250, practised: loss, kept: kept === null ? null : loss }))
  return [
    ...losses.flatMap((loss) => [errorWords(loss, false), errorWords(loss, true)]),
    ...[true, false].flatMap((shares) => [null, 1].map((kept) => curveWords(curve(kept), shares))),
    curveWords([], false),
    ...counts.map((count) => rowName(row(count, [count, null]), layers)),
    ...values.flatMap((value) => [number(value), signed(value, 2), offWords(value, 0), offWords(0, value)]),
    ...questions.map((question) => questionOf(question, layers)),
  ]
}

// ---- every message of these files, toasts among them ----

const files = [
  ...['app', 'missed', 'network', 'training', 'inside', 'time', 'files', 'share', 'editor', 'debug', 'robot'],
  ...['q-learning', 'blocks-network', 'blocks-q-learning', 'blocks-sorting', 'expert'],
]

/** Placeholders that count something; a screen passes them as they are. */
const counted: readonly string[] = ['count', 'seen', 'rows', 'passed', 'minutes']
/** Numbers of which there is never one, or that only name something. */
const others: { readonly [name: string]: number } = { needed: 20, knobs: 4, there: 9, here: 4, most: 64 }
const numbered: readonly string[] = ['layer', 'neuron', 'number', 'row', 'of', 'all', 'port']
/** Messages whose count is never one. */
const several: { readonly [key: string]: string } = {
  'network.inAll': 'the neurons of a layer that is too long for the screen',
  'net.refused.tooManyNeurons': 'more than fit',
  'problem.tooManyNeurons.title': 'more than fit',
  'problem.tooManyInLayer.title': 'more than fit',
  'q.watch.rides': 'so many rides that they show a chance',
  'q.watch.now': 'so many rides that they show a chance',
  'q.watch.done': 'so many rides that they show a chance',
}

/** A message with each number of the things that it counts; what else it holds is a name. */
function filled(key: string, text: unknown): readonly string[] {
  const names = [...JSON.stringify(text).matchAll(/\{(\w+)\}/g)].map(([, name]) => name!)
  const counting = names.some((name) => counted.includes(name))
  const some = counting ? counts.filter((count) => count > 1 || several[key] === undefined) : [2]
  return some.map((count) => {
    const facts = names.map((name) => {
      const value = counted.includes(name) ? count : (others[name] ?? (numbered.includes(name) ? 7 : 'Bo'))
      return [name, value] as const
    })
    return message(key, Object.fromEntries(facts))
  })
}

/** Faults of a message that its words alone do not have: in German null is a number. */
function faultyMessage(key: string, text: unknown, locale: string): readonly string[] {
  const own = faultsIn(JSON.stringify(text), locale)
  return filled(key, text).flatMap((filledIn) =>
    faultsIn(filledIn, locale)
      .filter((fault) => !own.includes(fault) || fault === 'a placeholder')
      .map((fault) => `${key}: ${fault}: ${filledIn}`),
  )
}

describe.each(['de', 'en'] as const)('in %s', (locale) => {
  beforeAll(() => language.speak(locale))
  afterAll(() => language.speak('en'))

  test('what there is to fix in blocks is a sentence without a fault, and so is each way out', () => {
    const sentences = findings.flatMap((finding) => {
      const { title, text, fixes } = wordsOf(
        finding,
        () => {},
        () => {},
      )
      return [title, text ?? '', ...fixes.map(({ label }) => label)]
    })
    expect(new Set(findings.map(({ problem }) => problem)).size).toBeGreaterThan(3)
    expect(faulty(sentences, locale)).toEqual([])
  })

  test('so is what Piep asks about examples, and what practice reads out', () => {
    const found = levels.flatMap((name) => {
      level.name = name
      const isExact = (fault: string) => name === 'expert' && fault.startsWith('too many places')
      return faulty(practiceSentences(), locale).filter((fault) => !isExact(fault))
    })
    expect(found).toEqual([])
  })

  test('so are the notes on a network that does not run', () => {
    const notes = (['off', 'behind', 'loose'] as const).flatMap((idle) => {
      const note = idleNote(idle, undefined)!
      return [note.title, note.text, note.label]
    })
    expect(faulty(notes, locale)).toEqual([])
  })

  test.each(files)('so is every message of %s, with none to many', (file) => {
    const found = Object.entries(tableOf(file, locale))
      // A neuron is called 1.2 in every language.
      .filter(([key]) => !/^(block|language)\.|^net\.hidden$/.test(key))
      .flatMap(([key, text]) => faultyMessage(key, text, locale))
    expect(found).toEqual([])
  })
})
