import type { Locator } from '@playwright/test'
import { RobotHands } from '../child-robot.ts'
import type { Child } from '../child.ts'
import { freeProgram } from '../projects.ts'
import { expect, opensCard, opensProject, test } from '../gate/gate.ts'
import { goesThrough, type Steps } from '../steps.ts'

test.use({ language: 'en' })

/** Steps in the dialog where a robot is built. */
function buildSteps(child: Child, bo: RobotHands): Steps {
  const { page } = child
  const button = (key: string) => bo.dialog.getByRole('button', { name: bo.word(key), exact: true })
  const undo = (way: 'undo' | 'redo') =>
    bo.dialog.getByRole('button', { name: child.word(`lab.${way}`), exact: true })
  const robot = bo.dialog.getByRole('button', { name: 'Rex', exact: true })
  const field = bo.dialog.getByRole('textbox', { name: bo.word('keptName') })
  const pulls = async (from: Locator, to: Locator) => {
    const [start, end] = [await child.middleOf(from), await child.middleOf(to)]
    await page.mouse.move(start.x, start.y)
    await page.mouse.down()
    await page.mouse.move(end.x, end.y, { steps: 4 })
  }
  /** The number follows a slider while it is held. */
  const holds = async (label: string, value: string) => {
    const output = bo.slider(label).locator('xpath=preceding-sibling::output')
    const before = await output.textContent()
    await bo.slider(label).evaluate((input: HTMLInputElement, to) => {
      input.value = to
      input.dispatchEvent(new Event('input', { bubbles: true }))
    }, value)
    await expect(output).not.toHaveText(before!)
    await bo.slider(label).fill(value)
  }
  return {
    'the robot from above': async () => {
      await opensCard(child, 'friendship')
      await bo.opens('build')
    },
    'a bumper is held': () => pulls(bo.onShelf('touch'), bo.port('4')),
    'it is plugged in': () => page.mouse.up(),
    'no room for one more': () => bo.onShelf('gyro').click(),
    'unplugged again': () => undo('undo').click(),
    'plugged in again': () => undo('redo').click(),
    'a sensor is chosen by its port': () => bo.port('1').getByRole('button').click(),
    'it is of another maker': () =>
      bo.dialog.getByRole('combobox', { name: bo.word('maker') }).selectOption('hitechnic'),
    'it is of its own maker': () =>
      bo.dialog.getByRole('combobox', { name: bo.word('maker') }).selectOption(''),
    'it is taken out by keys': () => bo.mark('colour', '1').press('Delete'),
    'one tap plugs in another one': () => bo.onShelf('infrared').click(),
    'a sensor is dragged': () => bo.dragsMark('ultrasonic', '2', { x: 10, y: 40 }),
    'it is turned left': () => button('turnLeft').click(),
    'it is turned right': async () => {
      await button('turnRight').click()
      await button('turnRight').click()
    },
    'it is turned by its handle': async () => {
      const from = await child.middleOf(bo.dialog.locator('.handle .knob'))
      await child.drags(from, { x: from.x + 40, y: from.y + 40 })
    },
    'it is moved by keys': () => bo.mark('ultrasonic', '2').press('ArrowDown'),
    'it is at another port': () =>
      bo.dialog.getByRole('combobox', { name: bo.word('port') }).selectOption('1'),
    'it is taken out': () => button('remove').click(),
    'a motor of a wheel': () => bo.motor('B').getByRole('button').click(),
    'it turns backwards': () => bo.setting('turns').selectOption('ON'),
    'it is not regulated': () => bo.setting('power').selectOption('FALSE'),
    'it turns the other wheel': () => bo.setting('wheel').selectOption('left'),
    'a free motor port': () => bo.motor('A').getByRole('button').click(),
    'a medium motor': () => bo.setting('plugged').selectOption('medium'),
    'something else': () => bo.setting('plugged').selectOption('other'),
    'a large motor': () => bo.setting('plugged').selectOption('large'),
    'it turns a wheel': () => bo.setting('wheel').selectOption('left'),
    'a sensor is chosen by its mark': () => bo.mark('ultrasonic', '3').focus(),
    'nothing is chosen': () =>
      bo.dialog.getByRole('group', { name: bo.word('picture') }).click({ position: { x: 5, y: 5 } }),
    'sensors are noisy': () => holds('noise', '7'),
    'and late': () => holds('delay', '9'),
    'a wheel is weaker': () => holds('unequal', '-4'),
    'the wheels': () => bo.dialog.locator('summary').click(),
    'larger wheels': () => holds('wheelDiameter', '7'),
    'farther apart': () => holds('trackWidth', '20'),
    'it has a name': () => field.fill('Rex'),
    'it is kept': () => bo.dialog.getByRole('button', { name: bo.word('keep'), exact: true }).click(),
    'a robot as new': () => button('asNew').click(),
    'a robot of the cards': () => button('asCards').click(),
    'the kept robot': () => robot.click(),
    'the kept robot goes': () =>
      bo.dialog.getByRole('button', { name: bo.word('leaveOut', { name: 'Rex' }), exact: true }).click(),
    'it comes back': () =>
      bo.dialog.getByRole('button', { name: bo.word('bringBack', { name: 'Rex' }), exact: true }).click(),
    'another robot cannot be kept': async () => {
      await page.evaluate(() => {
        Storage.prototype.setItem = () => {
          throw new DOMException('Refused for a test.', 'QuotaExceededError')
        }
      })
      await field.fill('Max')
      await field.press('Enter')
    },
    'the dialog is closed': () => bo.closes(),
    'all that it senses': () => bo.opens('senses'),
    'no table': () => child.presses('robot.close', { what: bo.word('senses') }),
  }
}

test('a robot is built, step by step', { tag: '@robot' }, async ({ child }) => {
  await goesThrough(child, 'robot-build', buildSteps(child, new RobotHands(child)))
})

/** Green lamp while the middle key is down, else red; a number on the display. */
const keys = freeProgram('Keys', (make) => {
  const lamp = (COLOUR: string) => make.block('actions_bricklight_on_ev3', { fields: { COLOUR, MODE: 'ON' } })
  const shown = make.block('robActions_display_text', {
    values: { OUT: make.number(42), COL: make.number(0), ROW: make.number(0) },
  })
  const key = make.block('robSensors_key_getSample', {
    fields: { MODE: 'PRESSED', SENSORPORT: 'ENTER', SLOT: '' },
  })
  return [shown, make.forever(make.ifElse(key, [lamp('GREEN')], [lamp('RED')]))]
})

test('the keys of a robot, step by step', { tag: '@robot' }, async ({ child, page }) => {
  const bo = new RobotHands(child)
  const lit = (colour: 'green' | 'red') => expect(bo.lamp(colour)).toBeVisible()
  await goesThrough(child, 'robot-panel', {
    'its keys and lamp': async () => {
      await opensProject(child, 'Keys', keys)
      await bo.opens('panel')
      await child.types('Escape')
    },
    'a program runs': async () => {
      await child.pressesStart()
      await lit('red')
    },
    'the key is down': async () => {
      const { x, y } = await child.middleOf(bo.key('enter'))
      await page.mouse.move(x, y)
      await page.mouse.down()
      await lit('green')
    },
    'the key is up': async () => {
      await page.mouse.up()
      await lit('red')
    },
    'the key is down by keys': async () => {
      await bo.key('enter').focus()
      await page.keyboard.down('Enter')
      await lit('green')
    },
    'the key is up by keys': async () => {
      await page.keyboard.up('Enter')
      await lit('red')
    },
    'the focus goes while it is down': async () => {
      await page.keyboard.down(' ')
      await lit('green')
      await bo.key('up').focus()
      await lit('red')
      await page.keyboard.up(' ')
      await child.pressesStop()
    },
    'the drawer is closed': () => child.presses('robot.close', { what: bo.word('panel') }),
  })
})
