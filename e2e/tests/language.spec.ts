import type { Block } from '@botgarten/blocks'
import type { Project } from '@botgarten/programs'
import type { Child } from '../child.ts'
import { RobotHands } from '../child-robot.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { Blocks } from '../runs/blocks.ts'
import { languages } from '../words.ts'

const text = (make: Blocks, TEXT: string) => make.block('text', { fields: { TEXT } })

/** A robot that waits, and beside it a text and a number that hang on nothing. */
function besides(): string {
  let [loose, stray]: (Block | undefined)[] = []
  const project = JSON.parse(
    freeProgram('Beside', (make) => {
      loose = text(make, 'Bo')
      stray = make.number(7)
      return [make.wait(500)]
    }),
  ) as Project
  const main = project.programs['main']!
  const stacks = [loose!, stray!].map((block, at) => ({ x: 40, y: 160 + at * 70, blocks: [block] }))
  return JSON.stringify({ ...project, programs: { main: { ...main, stacks: [...main.stacks, ...stacks] } } })
}

/** Bo 1 sends a word, Bo 2 shows what comes. */
function friends(): string {
  const make = new Blocks()
  const said = {
    mutation: { attrs: { datatype: 'String' } },
    fields: { TYPE: 'String', PROTOCOL: 'BLUETOOTH', CHANNEL: '-1' },
  }
  const call = make.block('robCommunication_startConnection', { values: { ADDRESS: text(make, 'Bo 2') } })
  const send = make.block('robCommunication_sendBlock', {
    ...said,
    values: { sendData: text(make, 'tok'), CONNECTION: call },
  })
  const called = make.block('robCommunication_waitForConnection')
  const came = make.block('robCommunication_receiveBlock', { ...said, values: { CONNECTION: called } })
  const show = make.block('robActions_display_text', {
    values: { OUT: came, COL: make.number(0), ROW: make.number(0) },
  })
  const { world, ...project } = JSON.parse(freeProgram('Friends', () => [])) as Project
  const [bo] = world.robots
  const robots = [bo!, { ...bo!, id: 'bo2', pose: { x: 60, y: 60, heading: 90 }, program: 'other' }]
  const programs = { main: make.program(send), other: make.program(show) }
  return JSON.stringify({ ...project, programs, world: { ...world, robots } })
}

/** Pulls a block by its corner into the gap of another. */
async function pulls(child: Child, block: string, gap: string) {
  const { x, y } = (await child.block(block).boundingBox())!
  const to = (await child.block(gap).boundingBox())!
  await child.drags({ x: x + 5, y: y + 15 }, { x: to.x + 8, y: to.y + 18 })
  await expect(child.page.locator('.blocklyDragging')).toHaveCount(0)
}

for (const language of languages) {
  test.describe(`blocks and what they mean, in ${language}`, () => {
    test.use({ language })

    test('only what fits is joined: a number goes where a number belongs, a text stays out', async ({
      child,
    }) => {
      await child.opensLab('free')
      await child.opensProject('Beside', besides())
      const inWait = child.block('b4').locator('[data-id]')
      await expect(inWait).toHaveAttribute('data-id', 'b3')
      await pulls(child, 'b1', 'b3')
      await expect(inWait).toHaveAttribute('data-id', 'b3')
      await pulls(child, 'b2', 'b3')
      await expect(inWait).toHaveAttribute('data-id', 'b2')
    })

    test('a robot reads on its display what another has sent it', async ({ child }) => {
      const crew = new TimeHands(child)
      const bo = new RobotHands(child)
      await child.opensLab('free')
      await child.opensProject('Friends', friends())
      await crew.chip(2).click()
      await bo.opens('panel')
      // It ends at once.
      await child.presses('lab.start')
      await expect(bo.drawer('panel').getByLabel(bo.word('display'))).toHaveText('tok')
    })
  })
}
