import { outcomeOf } from '@botgarten/experiments'
import { completeLanguages } from '@botgarten/messages/folder'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { gradeOf } from '../items/readability.ts'
import { readQuestion, type QuestionRun } from '../questions/index.ts'
import { plainOf } from '../schema/markdown.ts'
import { givenFor, setNamed, thingsOf } from './given.ts'
import './there.ts'

describe.each(content.questions)('the question $id', (question) => {
  it('has the answer that the simulation gives', () => {
    expect(outcomeOf(question.run, givenFor(question.run))).toBe(question.answer)
  })

  it.each(completeLanguages)(
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
