import { xmlTree } from '../../packages/programs/testing/xml-tree.ts'
import { leftEye, leftWheel } from '../child.ts'
import { Comer, openRobertaFile } from '../child-open-roberta.ts'
import { expect, test } from '../house.ts'
import { languages } from '../words.ts'

const friendship = openRobertaFile('thesis/friendship')
const action = openRobertaFile('programs/upstream__xNN__action')
const block = '<block type="a" id="b"></block>'

/** Files that are not opened, and what is said about each. */
const refused = [
  { what: 'half a file', text: friendship.slice(0, 900), problem: 'notXml', facts: { line: 1 } },
  { what: 'a web page', text: '<html><body/></html>', problem: 'notOpenRoberta', facts: {} },
  {
    what: 'another robot’s file',
    text: friendship.replaceAll('robottype="ev3"', 'robottype="calliope2017"'),
    problem: 'otherRobot',
    facts: { robot: 'calliope2017' },
  },
  {
    what: 'entities that blow up',
    text: `<!DOCTYPE e [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;">]>${friendship}`,
    problem: 'unsafeXml',
    facts: {},
  },
  { what: '50 MB', text: friendship.padEnd(50_000_000), problem: 'tooBig', facts: {} },
  {
    what: '100,000 blocks',
    text: friendship.replace('</instance>', `${block.repeat(100_000)}</instance>`),
    problem: 'tooManyBlocks',
    facts: { most: 10_000 },
  },
  {
    what: 'blocks in blocks without end',
    text: friendship.replace('</instance>', '<block type="a" id="a"><statement name="S">'.repeat(20_000)),
    problem: 'tooDeep',
    facts: {},
  },
] as const

for (const language of languages) {
  test.describe(`files of Open Roberta, in ${language}`, () => {
    test.use({ language })

    test('the thesis’s program opens from the menu, drives, and is saved with its weights', async ({
      child,
    }) => {
      const comer = new Comer(child)
      await child.opensLab('free')
      await comer.opens('Freundschaft.xml', friendship)
      await comer.seesProgram('Freundschaft')
      await child.typesWeight(leftEye, leftWheel, 0.8)
      await child.pressesStart()
      await child.seesDriving()
      await child.pressesStop()
      const { name, text } = await comer.saves()
      expect(name).toBe('Freundschaft.xml')
      await comer.opens('again.xml', text)
      await comer.seesProgram('again')
      await child.seesWeight(leftEye, leftWheel, 0.8)
    })

    test('what is not opened is named, and the open project stays as it was', async ({ child }) => {
      const comer = new Comer(child)
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.45)
      for (const { what, text, problem, facts } of refused)
        await test.step(what, async () => {
          await comer.opens('odd.xml', text)
          await comer.isToldWhy(problem, facts)
        })
      await child.seesWeight(leftEye, leftWheel, 0.45)
      await child.pressesStart()
    })
  })
}

test('a file is let go over the blocks, over the world, at home, over the projects', async ({
  child,
  page,
}) => {
  const comer = new Comer(child)
  await child.opensLab('free')
  await comer.drops('One.xml', friendship, '.blocklySvg')
  await comer.seesProgram('One')
  await comer.drops('Two.xml', friendship, '.floor')
  await comer.seesProgram('Two')
  await child.opensHome()
  await comer.drops('Three.xml', friendship)
  await comer.seesProgram('Three')
  await page.goto('/projects')
  await comer.drops('Four.xml', friendship)
  await comer.seesProgram('Four')
  await comer.drops('odd.xml', 'no')
  await comer.isToldWhy('notXml', { line: 1 })
})

test('a program of 195 blocks comes back out as it went in, by the keyboard alone', async ({
  child,
  page,
}) => {
  const comer = new Comer(child)
  await child.opensLab('free')
  await comer.opens('Action.xml', action)
  await comer.seesProgram('Action')
  const menu = child.button('lab.menu')
  await menu.focus()
  await page.keyboard.press('Enter')
  const entry = child.button('lab.saveOpenRoberta')
  await expect(entry).toBeVisible()
  await child.tabsTo(entry)
  const { text } = await comer.takes(() => page.keyboard.press('Enter'))
  expect(xmlTree(text)).toEqual(xmlTree(action))
})

test('blocks that nobody knows here are grey with their name, and are written back', async ({
  child,
  page,
}) => {
  const comer = new Comer(child)
  const odd = friendship.replace(
    '</instance>',
    '<block type="robActions_fly" id="odd"><field name="HEIGHT">3</field><comment w="1" h="2" pinned="false">hui</comment><value name="TO"><block type="math_number" id="n"><field name="NUM">1</field></block></value></block></instance>',
  )
  await child.opensLab('free')
  await comer.opens('Odd.xml', odd)
  await comer.seesProgram('Odd')
  await expect(page.locator('.blocklyBlockCanvas').last()).toContainText('robActions_fly')
  const { text } = await comer.saves()
  expect(text).toContain('<block type="robActions_fly" id="odd"><field name="HEIGHT">3</field>')
  expect(text).toContain('hui')
})
