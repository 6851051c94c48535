import { completeLanguages } from '@botgarten/messages/folder'
import { describe, expect, test } from 'vitest'
import { content } from '../files.ts'
import { atGrade } from '../items/pack.ts'
import type { Item } from '../schema/itemTypes.ts'
import { textOf } from './there.ts'

const items = new Map(content.items.map((item) => [item.id, item]))
const plans = content.items.filter(({ plan }) => plan)
const pupils = content.items.filter(({ audience }) => audience === 'pupils')

const youngest = 3
const oldest = 12
const gradesOf = ([from, to]: Item['grades']) => Array.from({ length: to - from + 1 }, (_, at) => from + at)
const isFor = ({ grades: [from, to] }: Pick<Item, 'grades'>, grade: number) => from <= grade && grade <= to

/** What `item:<id>` or `card:<id>` is for a grade: of a sheet with reading levels the one of that grade. */
function copiedAt(of: string, grade: number): Pick<Item, 'grades'> {
  const [kind, id] = of.split(':') as [string, string]
  return kind === 'item' ? items.get(atGrade(items.get(id)!, grade))! : content.card(id)!.card
}

describe.each(plans)('the lesson of $code', ({ grades, plan }) => {
  test('copies nothing that is not for each of its grades, or has a reading level for it', () => {
    const wrong = gradesOf(grades).flatMap((grade) =>
      plan!.copies.flatMap(({ of }) =>
        isFor(copiedAt(of, grade), grade) ? [] : [`${of} in grade ${grade}`],
      ),
    )
    expect(wrong).toEqual([])
  })

  test('has answers for its grades', () => {
    const answers = content.items.find(
      ({ kind, code }) => kind === 'solution' && code === `A ${plan!.lesson}`,
    )
    if (answers) expect(answers.grades).toEqual(grades)
  })
})

test('hardly anything is for all grades at once', () => {
  const forAll = pupils.filter(({ grades: [from, to] }) => from === youngest && to === oldest)
  expect(forAll.length).toBeLessThanOrEqual(pupils.length / 10)
})

/** Percent, a decimal, a product, a number below zero: none of it is taught before grade 5. */
const reckoned = /%|[Pp]ro[zc]ent|percent|\d[.,]\d|[\d_] ?[·×] ?[\d_]|(?<![\d–])[−-]\d/

test.each(completeLanguages)('third and fourth graders read numbers that they know, in "%s"', (language) => {
  const young = pupils.filter(({ grades: [from], kind }) => from <= 4 && kind !== 'slides')
  const written = ({ id }: Item) =>
    textOf(content.itemFolder(id), `${language}.md`).replaceAll(/^::.*$/gm, '')
  expect(young.length).toBeGreaterThan(20)
  expect(young.filter((item) => reckoned.test(written(item))).map(({ id }) => id)).toEqual([])
})
