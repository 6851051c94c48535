// Rooms: editor
import type { Project } from '@botgarten/programs'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

const calls = { mutation: { attrs: { name: 'again' } } }

/** A function that calls itself, and the program that calls it. */
function recursion(): string {
  const text = freeProgram('Again', (make) => [
    make.drive(30, 5),
    make.block('robProcedures_callnoreturn', calls),
  ])
  const { programs, ...project } = JSON.parse(text) as Project
  const again = {
    ...{ id: 'again', type: 'robProcedures_defnoreturn', fields: { NAME: 'again' } },
    mutation: { attrs: { declare: 'false' } },
    statements: { STACK: [{ id: 'call', type: 'robProcedures_callnoreturn', ...calls }] },
  }
  const main = programs['main']!
  const stacks = [...main.stacks, { x: 0, y: 300, blocks: [again] }]
  return JSON.stringify({ ...project, programs: { main: { ...main, stacks } } })
}

/** Shows a number, then makes a list of a million at once. */
const million = () =>
  freeProgram('Million', (make) => [
    make.block('robActions_display_text', {
      values: {
        OUT: make.block('robLists_length', {
          values: {
            VALUE: make.block('robLists_repeat', {
              mutation: { attrs: { list_type: 'Number' } },
              fields: { LIST_TYPE: 'Number' },
              values: { ITEM: make.number(7), NUM: make.number(1_000_000) },
            }),
          },
        }),
        COL: make.number(0),
        ROW: make.number(0),
      },
    }),
  ])

/** Puts an entry at the end of a list, forever: a million of them in the end. */
function growing(): string {
  const list = { mutation: { attrs: { datatype: 'Array_Number' } }, fields: { VAR: 'list' } }
  const text = freeProgram('Growing', (make) => [
    make.forever(
      make.block('robLists_setIndex', {
        mutation: { attrs: { at: 'false' } },
        fields: { MODE: 'INSERT', WHERE: 'LAST' },
        values: { LIST: make.block('variables_get', list), TO: make.number(1) },
      }),
    ),
  ])
  const { programs, ...project } = JSON.parse(text) as Project
  const main = programs['main']!
  const [start, ...rest] = main.stacks[0]!.blocks
  const declared = {
    ...{ id: 'declared', type: 'robGlobalVariables_declare' },
    fields: { VAR: 'list', TYPE: 'Array_Number' },
    mutation: { attrs: { next: 'false', declaration_type: 'Array_Number' } },
    values: {
      VALUE: {
        ...{ id: 'empty', type: 'robLists_create_with', fields: { LIST_TYPE: 'Number' } },
        mutation: { attrs: { items: '0', list_type: 'Number' } },
      },
    },
  }
  const first = {
    ...start!,
    mutation: { attrs: { declare: 'true' } },
    statements: { ST: [declared] },
  }
  const stacks = [{ x: 0, y: 0, blocks: [first, ...rest] }]
  return JSON.stringify({ ...project, programs: { main: { ...main, stacks } } })
}

interface Endless {
  readonly name: string
  readonly text: string
  /** A block that can be doubled. */
  readonly block: string
  readonly problem: string
  readonly facts: { readonly [name: string]: string | number }
}

const endless: readonly Endless[] = [
  { name: 'Again', text: recursion(), block: 'b4', problem: 'tooManyCalls', facts: { name: 'again' } },
  { name: 'Million', text: million(), block: 'b7', problem: 'listTooLong', facts: { most: 10_000 } },
  { name: 'Growing', text: growing(), block: 'b4', problem: 'listTooLong', facts: { most: 10_000 } },
]

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`programs without end, in ${language}`, () => {
    test.use({ language })

    for (const { name, text, block, problem, facts } of endless)
      test(`${name}: it is said why it stops, the blocks stay as they were, and the page goes on`, async ({
        child,
        page,
      }) => {
        const title = child.word(`problem.${problem}.title`, facts)
        const said = page.getByRole('status').filter({ hasText: title })
        await child.opensProjectAtHome(name, text)
        const before = JSON.parse(await child.savesFile()) as Project
        await page.keyboard.press('Escape')
        await child.presses('lab.start')
        if (name === 'Growing') await new TimeHands(child).hurries()
        await expect(said).toBeVisible()
        await expect(child.button('lab.start').first()).toBeVisible()

        const after = JSON.parse(await child.savesFile()) as Project
        expect(after.programs).toEqual(before.programs)
        await page.keyboard.press('Escape')
        // The page still does what it is told: a block more, taken back, and the run once more.
        await child.block(block).click({ position: { x: 12, y: 12 } })
        await page.keyboard.press('d')
        await expect(child.button('lab.undo')).toBeEnabled()
        await child.presses('lab.undo')
        const again = JSON.parse(await child.savesFile()) as Project
        expect(again.programs).toEqual(before.programs)
        await page.keyboard.press('Escape')
        await child.presses('lab.start')
        await expect(said).toBeVisible()
      })
  })
}
