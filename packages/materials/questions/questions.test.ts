import { globSync, readFileSync } from 'node:fs'
import { basename, dirname, join } from 'node:path'
import { paintFloor, readPng, type World } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { cardDocument, readCard, type CardProgram } from '../index.ts'
import { gradeOf } from '../items/readability.ts'
import { cardFolder, content, languages, read, textOf } from '../items/testing/catalogue.ts'
import { plainOf } from '../markdown.ts'
import { readMap } from '@botgarten/maps'
import { readThings } from '../things/index.ts'
import { learningIn } from '@botgarten/programs'
import { outcomeOf, readQuestion, readQuestionText, type Given, type QuestionRun } from './index.ts'

const folders = globSync('materials/questions/*/question.json', { cwd: content }).sort().map(dirname)

function givenFor(run: QuestionRun): Given {
  if (run.observe === 'group')
    return { kind: 'things', set: readThings(read('things', run.set, 'things.json')) }
  const folder = cardFolder(run.card)
  const card = readCard(read(folder, 'card.json'))
  const world = read('worlds', card.world, 'world.json') as World
  const program = read(folder, `${run.file}.json`) as CardProgram
  const document = cardDocument(world, card, program, 'start' in run ? run.start : 0)
  if (run.observe !== 'way') return { kind: 'lab', document, floor: floorOf(document.world) }
  const { map } = learningIn(document.programs[world.robots[0]!.program]!)!
  const svg = readFileSync(join(content, 'maps', map, 'map.svg'), 'utf8')
  return { kind: 'learning', document, map: readMap(svg).map! }
}

function floorOf(world: World) {
  if (!('asset' in world.floor)) return paintFloor(world)
  const file = join(content, world.floor.asset.replace('content:', ''))
  return paintFloor(world, readPng(readFileSync(file)))
}

describe.each(folders)('the question in %s', (folder) => {
  const question = readQuestion(read(folder, 'question.json'))

  it('is named like its folder', () => {
    expect(basename(folder)).toMatch(new RegExp(`^\\d\\d-${question.id}$`))
  })

  it('has the answer that the simulation gives', () => {
    expect(outcomeOf(question.run, givenFor(question.run))).toBe(question.answer)
  })

  it.each(languages)(
    'has words in "%s" for each choice, and says why, as simply as its grade reads',
    (language) => {
      const text = readQuestionText(textOf(folder, language))
      expect(Object.keys(text.choices)).toEqual(question.choices)
      const words = [text.question, ...Object.values(text.choices), ...text.why.map(plainOf)].join('\n')
      const grade = gradeOf(words, language)
      if (grade !== null) expect(grade).toBeLessThanOrEqual(question.grades[0] + 1)
    },
  )
})

describe('the questions', () => {
  it('are at least three a module', () => {
    const modules = folders.map((folder) => readQuestion(read(folder, 'question.json')).module)
    for (const module of [1, 2, 3, 4])
      expect(modules.filter((one) => one === module).length).toBeGreaterThanOrEqual(3)
  })

  it('refuse what cannot be seen in what is given', () => {
    const set = readThings(read('things/vessels/things.json'))
    const run: QuestionRun = { observe: 'way', card: 'railway', file: 'solution' }
    expect(() => outcomeOf(run, { kind: 'things', set })).toThrow(TypeError)
    const group = {
      observe: 'group',
      set: 'vessels',
      features: ['width'],
      flags: ['vessel-1', 'vessel-2'],
    } as const
    expect(() => outcomeOf({ ...group, thing: 'vessel-99' }, { kind: 'things', set })).toThrow(RangeError)
  })

  it('refuse an answer that is no choice', () => {
    const question = read(folders[0]!, 'question.json') as object
    expect(() => readQuestion({ ...question, answer: 'flies' })).toThrow(/one of the choices/)
  })
})
