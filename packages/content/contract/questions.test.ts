import { readFileSync } from 'node:fs'
import { outcomeOf, type Given } from '@botgarten/experiments'
import { readMap } from '@botgarten/maps'
import { learningIn } from '@botgarten/programs'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { cardDocument } from '../index.ts'
import { gradeOf } from '../items/readability.ts'
import { readQuestion, type QuestionRun } from '../questions/index.ts'
import { plainOf } from '../schema/markdown.ts'
import type { ThingSet } from '../schema/thingTypes.ts'
import { columnsOf, onPlane, rawOf } from '../things/index.ts'
import './there.ts'

const setNamed = (id: string) => content.sets.find((set) => set.id === id)!

function thingsOf(set: ThingSet, features: readonly string[]): Given {
  const columns = columnsOf(set, features)
  const rows = set.things.map(
    (thing) => [thing.id, columns.map((column) => onPlane(rawOf(set, thing, column), column))] as const,
  )
  return { kind: 'things', things: new Map(rows) }
}

function cageGiven(id: string): Given {
  const { cage } = content.cages.find((one) => one.cage.id === id)!
  return { kind: 'cage', cage, map: readMap(readFileSync(content.mapOfCage(id), 'utf8')).map! }
}

function givenFor(run: QuestionRun): Given {
  if (run.observe === 'group') return thingsOf(setNamed(run.set), run.features)
  if (run.observe === 'cage') return cageGiven(run.cage)
  const { card, world } = content.card(run.card)!
  const program = content.program(run.card, run.file)!
  const document = cardDocument(world, card, program, 'start' in run ? run.start : 0)
  if (run.observe !== 'way') return { kind: 'lab', document, floor: content.floorOf(document.world) }
  const { map } = learningIn(document.programs[world.robots[0]!.program]!)!
  return { kind: 'learning', document, map: content.mapFile(map)! }
}

describe.each(content.questions)('the question $id', (question) => {
  it('has the answer that the simulation gives', () => {
    expect(outcomeOf(question.run, givenFor(question.run))).toBe(question.answer)
  })

  it.each(content.languages)(
    'has words in "%s" for each choice, and says why, as simply as its grade reads',
    (language) => {
      const text = content.itemTexts(language).questions[question.id]!
      expect(Object.keys(text.choices)).toEqual(question.choices)
      const words = [text.question, ...Object.values(text.choices), ...text.why.map(plainOf)].join('\n')
      const grade = gradeOf(words, language)
      if (grade !== null) expect(grade).toBeLessThanOrEqual(question.grades[0] + 1)
    },
  )
})

describe('the questions', () => {
  it('are at least three a module', () => {
    const modules = content.questions.map(({ module }) => module)
    for (const module of [1, 2, 3, 4])
      expect(modules.filter((one) => one === module).length).toBeGreaterThanOrEqual(3)
  })

  it('refuse what cannot be seen in what is given', () => {
    const things = thingsOf(setNamed('vessels'), ['width'])
    const run: QuestionRun = { observe: 'way', card: 'railway', file: 'solution' }
    expect(() => outcomeOf(run, things)).toThrow(TypeError)
    const group = {
      observe: 'group',
      set: 'vessels',
      features: ['width'],
      flags: ['vessel-1', 'vessel-2'],
    } as const
    expect(() => outcomeOf({ ...group, thing: 'vessel-99' }, things)).toThrow(RangeError)
  })

  it('refuse an answer that is no choice', () => {
    const question = content.questions[0]!
    expect(() => readQuestion({ ...question, answer: 'flies' })).toThrow(/one of the choices/)
  })
})
