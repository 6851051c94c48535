// Rooms: open-roberta
import { readFileSync } from 'node:fs'
import { strFromU8, unzipSync } from 'fflate'
import { xmlTree } from '../../packages/programs/testing/xml-tree.ts'
import { leftEye, leftWheel, type Child } from '../child.ts'
import { Comer, openRobertaFile } from '../child-open-roberta.ts'
import { ProjectList } from '../child-projects.ts'
import { RobotHands } from '../child-robot.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

const friendship = openRobertaFile('thesis/friendship')
const action = openRobertaFile('programs/upstream__xNN__action')
/** Its start stands at 554, 49, its functions further down on the left. */
const far = openRobertaFile('programs/upstream__xNN__text_colours_messages_functions')
const block = '<block type="a" id="b"></block>'

/** A configuration with things that Bo has not. */
const plugged = (place: string, type: string, fields: { readonly [name: string]: string } = {}, id = place) =>
  `<value name="${place}"><block type="robBrick_${type}" id="${id}">${Object.entries(fields)
    .map(([name, value]) => `<field name="${name}">${value}</field>`)
    .join('')}</block></value>`
const motor = (MOTOR_REGULATION: string, MOTOR_REVERSE: string, MOTOR_DRIVE?: string) => ({
  ...{ MOTOR_REGULATION, MOTOR_REVERSE },
  ...(MOTOR_DRIVE && { MOTOR_DRIVE }),
})
const withPlugs = (...values: readonly string[]) =>
  action.replace(
    /(<block type="robBrick_EV3-Brick"[^>]*>)[^]*?(<\/block>\s*<\/instance>)/,
    (_, brick: string, end: string) =>
      `${brick}<field name="WHEEL_DIAMETER">5.6</field><field name="TRACK_WIDTH">18</field>${values.join('')}${end}`,
  )
const plugs = withPlugs(
  plugged('S4', 'irseeker'),
  plugged('MB', 'motor_big', motor('TRUE', 'ON', 'LEFT')),
  plugged('MC', 'motor_big', motor('TRUE', 'OFF', 'RIGHT')),
  plugged('MD', 'motor_middle', motor('FALSE', 'OFF')),
)

/** Opens that file, and what is plugged into its robot. */
async function rebuildsPlugs(child: Child) {
  const comer = new Comer(child)
  const bo = new RobotHands(child)
  await comer.opensAtHome('Plugs.xml', plugs)
  await comer.seesProgram('Plugs')
  await bo.opens('build')
  return { comer, bo }
}

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

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`files of Open Roberta, in ${language}`, () => {
    test.use({ language })

    test('the thesis’s program opens from the menu, drives, and is saved with its weights', async ({
      child,
    }) => {
      const comer = new Comer(child)
      await comer.opensAtHome('Freundschaft.xml', friendship)
      await comer.seesProgram('Freundschaft')
      await child.typesWeight(leftEye, leftWheel, 0.8)
      await child.pressesStart()
      await child.seesDriving()
      await child.pressesStop()
      const { name, text } = await comer.saves('asItIs')
      expect(name).toBe('Freundschaft.xml')
      await comer.opens('again.xml', text)
      await comer.seesProgram('again')
      await child.seesWeight(leftEye, leftWheel, 0.8)
    })

    test('a file whose start stands far away on its paper opens there, and again after a reload', async ({
      child,
      page,
    }) => {
      const comer = new Comer(child)
      await comer.opensAtHome('Far.xml', far)
      await comer.seesProgram('Far')
      const start = page.locator('.blocklyBlockCanvas > .blocklyDraggable').getByText(/^(when|wenn)$/)
      await expect(start.first()).toBeInViewport()
      await child.seesSaved()
      await child.reloads()
      await expect(start.first()).toBeInViewport()
      expect(xmlTree((await comer.saves()).text)).toEqual(xmlTree(far))
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

test('a file is let go over the blocks, over the world, at home, over the projects', async ({ child }) => {
  const comer = new Comer(child)
  await child.opensLab('free')
  await comer.drops('One.xml', friendship, '.blocklySvg')
  await comer.seesProgram('One')
  await comer.drops('Two.xml', friendship, '.floor')
  await comer.seesProgram('Two')
  await child.opensHome()
  await comer.drops('Three.xml', friendship)
  await comer.seesProgram('Three')
  await new ProjectList(child).opens()
  await comer.drops('Four.xml', friendship)
  await comer.seesProgram('Four')
  await comer.drops('odd.xml', 'no')
  await comer.isToldWhy('notXml', { line: 1 })
})

test('a block that nobody knows is told at its block; Bo runs up to it, and the notice leads there', async ({
  child,
  page,
}) => {
  const comer = new Comer(child)
  const waits = Array.from(
    { length: 30 },
    (_, k) =>
      `<block type="robControls_wait_time" id="w${k}"><value name="WAIT"><block type="math_number" id="n${k}"><field name="NUM">1</field></block></value></block>`,
  ).join('')
  const start = /(<block type="robControls_start"[^>]*>.*?<\/block>)/s
  const odd = friendship.replace(start, `$1${waits}<block type="robActions_fly" id="odd"></block>`)
  await comer.opensAtHome('Odd.xml', odd)
  await comer.seesProgram('Odd')
  const block = page.locator('.blocklyDraggable[data-id="odd"]')
  await expect(block).not.toBeInViewport()
  await child.presses('lab.start')
  await expect(child.words('problem.unknownBlock.title')).toBeVisible()
  await expect(block).toBeInViewport()
  await expect(child.button('lab.start')).not.toHaveAttribute('aria-disabled', 'true')
  await page.locator('.blocklySvg').first().hover()
  await page.mouse.wheel(0, -4000)
  await expect(block).not.toBeInViewport()
  await child.presses('lab.showBlock')
  await expect(block).toBeInViewport()
  await expect(block).toHaveClass(/blocklySelected/)
})

test('what Open Roberta does not know is named, and the network can be said in its blocks', async ({
  child,
}) => {
  const comer = new Comer(child)
  await comer.opensAtHome('Friends.xml', friendship)
  await comer.seesProgram('Friends')
  await child.typesWeight(leftEye, leftWheel, 0.8)
  const { text } = await comer.saves('asSteps')
  expect(text).not.toContain('"ai_')
  expect(text).toContain('robActions_NNstep')
  await comer.opens('Steps.xml', text)
  await comer.seesProgram('Steps')
  await child.pressesStart()
  await child.seesDriving()
  await child.pressesStop()
})

test('all programs of this device are taken to Open Roberta in one archive', async ({ child, page }) => {
  const comer = new Comer(child)
  await comer.opensAtHome('Friends.xml', friendship)
  await comer.seesProgram('Friends')
  await comer.opens('Action.xml', action)
  await comer.seesProgram('Action')
  await new ProjectList(child).opens()
  const [archive] = await Promise.all([page.waitForEvent('download'), child.presses('openRoberta.takeAll')])
  expect(archive.suggestedFilename()).toBe('Botgarten for Open Roberta.zip')
  const files = unzipSync(readFileSync(await archive.path()))
  const folder = child.word('openRoberta.folder')
  expect(Object.keys(files).sort()).toEqual(['Action.xml', 'Friends.xml', `${folder}/Friends.xml`].sort())
  expect(xmlTree(strFromU8(files['Action.xml']!))).toEqual(xmlTree(action))
})

test('what may end a program here and not in Open Roberta is said when it is opened', async ({
  child,
  page,
}) => {
  const comer = new Comer(child)
  await comer.opensAtHome('Lists.xml', openRobertaFile('programs/composed__common__listOperationsBasic'))
  await comer.seesProgram('Lists')
  const panel = page.getByRole('status').filter({ hasText: child.word('openRoberta.ends.title') })
  await expect(panel).toContainText(child.word('openRoberta.ends.place'))
  await child.presses('openRoberta.ends.show.place')
  await expect(
    page.locator('.robLists_getIndex.blocklySelected, .robLists_setIndex.blocklySelected'),
  ).toBeInViewport()
  await panel.getByRole('button', { name: child.word('parts.close'), exact: true }).click()
  await expect(panel).toBeHidden()
  await child.reloads()
  await expect(panel).toBeHidden()
})

test('a robot is kept by name, used again in another project, left out and brought back', async ({
  child,
  page,
}) => {
  const { bo } = await rebuildsPlugs(child)
  const named = bo.dialog.getByRole('button', { name: 'Rex', exact: true })
  await bo.dialog.getByRole('textbox', { name: bo.word('keptName') }).fill('Rex')
  await page.keyboard.press('Enter')
  await expect(named).toBeVisible()
  await bo.closes()
  const projects = new ProjectList(child)
  await projects.opens()
  await projects.begins('Another')
  await bo.opens('build')
  await bo.dialog.getByRole('button', { name: bo.word('leaveOut', { name: 'Rex' }) }).click()
  await expect(named).toHaveCount(0)
  await bo.dialog.getByRole('button', { name: bo.word('bringBack', { name: 'Rex' }) }).click()
  await named.click()
  await bo.seesAtPort('4', 'irseeker')
  await expect(bo.motor('D')).toContainText(bo.word('plug.motor_middle'))
})
