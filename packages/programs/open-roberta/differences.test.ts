import { addBlocks, type CheckContext, type Template } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { expect, it } from 'vitest'
import { indexProgram, runThread, startThread, type Program } from '../index.ts'
import { block, calculate, distance, forever, number, programOf, show, start } from '../testing/build.ts'
import { givenFiles } from '../testing/mutations.ts'
import { cardSensors, nextTick, recordingRobot } from '../testing/recording-robot.ts'
import { robotIn } from './brick.ts'
import { differencesOf } from './differences.ts'
import { readOpenRoberta } from './index.ts'

addBlocks(expert)

const kindsOf = (...rows: Template[]) =>
  differencesOf(programOf([start, ...rows]), { sensors: cardSensors }).map(({ kind }) => kind)

it('dividing by what may be 0 is named, by a number it is not', () => {
  expect(kindsOf(show(calculate('DIVIDE', number(1), distance())))).toEqual(['dividing'])
  expect(kindsOf(show(calculate('DIVIDE', number(1), number(0))))).toEqual(['dividing'])
  expect(kindsOf(show(calculate('DIVIDE', number(1), number(2))))).toEqual([])
  expect(kindsOf(show(block('math_modulo', {}, { DIVIDEND: number(1), DIVISOR: distance() })))).toEqual([
    'dividing',
  ])
})

it('a sensor that is not there and a block that nobody knows are named, only where they are reached', () => {
  expect(kindsOf(forever(show(distance('4')), block('robActions_fly')))).toEqual(['port', 'unknown'])
  const apart = programOf([start], [show(distance('4')), block('robActions_fly')])
  expect(differencesOf(apart, { sensors: cardSensors })).toEqual([])
})

/** What ends programs here and not in Open Roberta, by the problem that the run names. */
const kinds: { readonly [problem: string]: string } = {
  'problem.divisionByZero': 'dividing',
  'problem.noSuchEntry': 'place',
  'problem.nothingToRead': 'port',
}

/** The problem that a program ends with within fifty seconds. */
function endOf(program: Program, sensors: CheckContext['sensors']): string | undefined {
  const recording = recordingRobot(2, sensors)
  const index = indexProgram(program)
  const thread = startThread(index)
  while (!thread.ended && recording.tick < 3000) {
    runThread(thread, index, recording.context)
    nextTick(recording)
  }
  return thread.problem?.problem
}

it('every given file that ends in such a way is told of before it runs', () => {
  const told: string[] = []
  for (const [file, text] of Object.entries(givenFiles())) {
    const program = readOpenRoberta(text)
    for (const sensors of [robotIn(program.config).sensors, cardSensors]) {
      const kind = kinds[endOf(program, sensors) ?? '']
      if (kind === undefined) continue
      told.push(kind)
      const named = differencesOf(program, { sensors }).map((one) => one.kind)
      expect(named, file).toContain(kind)
    }
  }
  expect(new Set(told)).toEqual(new Set(['dividing', 'place', 'port']))
}, 60_000)
