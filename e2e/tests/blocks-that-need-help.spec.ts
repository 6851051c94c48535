// Rooms: editor
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { freeProgram, projectFile } from '../projects.ts'
import { languagesOf } from '../words.ts'

/** The panel below the blocks that says what is wrong. */
const panel = (child: Child, problem: string, facts = {}) =>
  child.page.getByRole('status').filter({ hasText: child.word(`problem.${problem}.title`, facts) })

/** The badge at the corner of a block. */
const badge = (child: Child, block: string, problem: string, facts = {}) =>
  child
    .block(block)
    .getByRole('button', {
      name: child.word('editor.finding', { title: child.word(`problem.${problem}.title`, facts) }),
    })
    .first()

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`blocks that need help, in ${language}`, () => {
    test.use({ language })

    test('a sensor at an empty port is said at its block, and one tap mends it', async ({ child }) => {
      const broken = projectFile('friendship', 'solution').replace('ULTRASONIC_PORT_2', 'ULTRASONIC_PORT_4')
      await child.opensProjectAtHome('Friendship', broken)
      const facts = { port: '4', other: '2' }
      await expect(panel(child, 'noDistanceSensorEmpty', facts)).toContainText(
        child.word('problem.noDistanceSensorEmpty.text', facts),
      )
      await expect(badge(child, 'eyeLeft', 'noDistanceSensorEmpty', facts)).toBeVisible()
      await expect(child.button('lab.start')).toHaveAttribute('aria-disabled', 'true')
      await expect(child.words('session.needsHelp')).toBeVisible()

      await child.presses('problem.fix.port', { port: '2' })
      await expect(panel(child, 'noDistanceSensorEmpty', facts)).toBeHidden()
      await expect(badge(child, 'eyeLeft', 'noDistanceSensorEmpty', facts)).toBeHidden()
      await child.pressesStart()
      await child.seesDriving()
    })

    test('a division by zero stops the robot and is said at its block; mended, it drives', async ({
      child,
    }) => {
      const ids = { zero: '', division: '' }
      const divides = freeProgram('Null', (make) => {
        const zero = make.number(0)
        const division = make.calculate('DIVIDE', make.number(60), zero)
        Object.assign(ids, { zero: zero.id, division: division.id })
        const driving = [make.motor('C', make.number(40)), make.wait(200)]
        return [...driving, make.forever(make.motor('B', division))]
      })
      await child.opensProjectAtHome('Null', divides)
      await child.presses('lab.start')
      await expect(panel(child, 'divisionByZero')).toContainText(child.word('problem.divisionByZero.text'))
      await expect(badge(child, ids.division, 'divisionByZero')).toBeVisible()
      await child.seesStanding()

      await child.typesNumber(ids.zero, '2')
      await expect(panel(child, 'divisionByZero')).toBeHidden()
      await expect(badge(child, ids.division, 'divisionByZero')).toBeHidden()
      await child.pressesStart()
      await child.seesDriving()
    })
  })
}

const loops = [
  ['that holds nothing', (make) => [make.forever()]],
  [
    'that only calculates',
    (make) => [make.forever(make.ifElse(make.compare('EQ', make.number(1), make.number(2)), [], []))],
  ],
  ['in a loop, both empty', (make) => [make.forever(make.forever())]],
  ['that repeats a million times', (make) => [make.forever(make.repeat(1_000_000, make.repeat(1_000_000)))]],
] satisfies [string, Parameters<typeof freeProgram>[1]][]

test('no loop freezes the page, whatever it holds', async ({ child }) => {
  await child.opensLab('free')
  for (const [what, stack] of loops)
    await test.step(`a loop ${what}`, async () => {
      await child.opensProject(what, freeProgram(what, stack))
      await child.pressesStart()
      await child.watches(60)
      await child.presses('lab.pause')
      await child.presses('lab.continue')
      await child.watches(60)
      await child.speaks(child.language === 'en' ? 'de' : 'en')
      await child.pressesStop()
    })
})
