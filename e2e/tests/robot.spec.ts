// Rooms: robot
import type { Project } from '@botgarten/programs'
import { leftEye, type Child } from '../child.ts'
import { RobotHands } from '../child-robot.ts'
import { expect, test } from '../house.ts'
import { freeProgram, projectFile } from '../projects.ts'
import { languagesOf } from '../words.ts'

/** The panel below the blocks that says what is wrong. */
const said = (child: Child, problem: string, facts = {}) =>
  child.page.getByRole('status').filter({ hasText: child.word(`problem.${problem}.title`, facts) })

/** Attributes are compared letter by letter, with the space before a unit that does not break. */
const spoken = (words: string) => words.replaceAll(/(\d) /g, '$1\u00a0')

/** Green lamp and a word while the middle key is down, else red. */
const keyProgram = () =>
  freeProgram('Keys', (make) => {
    const lamp = (COLOUR: string) =>
      make.block('actions_bricklight_on_ev3', { fields: { COLOUR, MODE: 'ON' } })
    const shown = make.block('robActions_display_text', {
      values: { OUT: make.number(42), COL: make.number(0), ROW: make.number(0) },
    })
    const key = make.block('robSensors_key_getSample', {
      fields: { MODE: 'PRESSED', SENSORPORT: 'ENTER', SLOT: '' },
    })
    return [shown, make.forever(make.ifElse(key, [lamp('GREEN')], [lamp('RED')]))]
  })

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`the robot, in ${language}`, () => {
    test.use({ language })

    test('shows all six of its keys without scrolling', async ({ child }) => {
      const bo = new RobotHands(child)
      for (const card of ['friendship', 'rally']) {
        await child.opensLab(card)
        await bo.opens('panel')
        for (const key of ['escape', 'up', 'left', 'enter', 'right', 'down'] as const)
          await expect(bo.key(key)).toBeInViewport({ ratio: 0.99 })
        await bo
          .drawer('panel')
          .getByRole('button', { name: child.word('robot.close', { what: bo.word('panel') }) })
          .click()
      }
    })

    test('is rebuilt by mouse: plugged in, moved, turned, taken out, each one step', async ({ child }) => {
      const bo = new RobotHands(child)
      await child.opensLab('friendship')
      await bo.opens('build')
      await bo.seesAtPort('4', null)
      await bo.dragsFromShelf('touch', bo.port('4'))
      await bo.seesAtPort('4', 'touch')
      await expect(bo.mark('touch', '4')).toHaveAttribute('aria-pressed', 'true')
      await bo.dialog.getByRole('button', { name: child.word('lab.undo') }).click()
      await bo.seesAtPort('4', null)
      await bo.dialog.getByRole('button', { name: child.word('lab.redo') }).click()
      await bo.seesAtPort('4', 'touch')

      await bo.dragsMark('ultrasonic', '2', { x: 0, y: 56 })
      await expect(bo.dialog).toContainText(bo.word('ahead', { length: 5 }))
      await bo.dialog.getByRole('button', { name: bo.word('turnLeft') }).click()
      await expect(bo.dialog).toContainText(bo.word('turnedLeft', { degrees: 25 }))
      await bo.dialog.getByRole('button', { name: bo.word('remove') }).click()
      await bo.seesAtPort('2', null)
      await bo.closes()

      // Playground and findings follow, and one tap plugs it in again.
      const facts = { port: '2', other: '3' }
      await expect(said(child, 'noDistanceSensorEmpty', facts)).toBeVisible()
      await child.presses('problem.fix.plug', { port: '2' })
      await expect(said(child, 'noDistanceSensorEmpty', facts)).toBeHidden()
      await child.pressesStart()
      await child.pressesStop()
    })

    test('an infrared sensor shows its cone and what it reads, 0 to 100, like the distance sensors theirs', async ({
      child,
    }) => {
      const bo = new RobotHands(child)
      const ray = async () => (await child.painted.places()).find(({ name }) => name === 'bo ray 4')
      await child.opensLab('friendship')
      await expect.poll(ray).toBeUndefined()
      await bo.opens('build')
      await bo.dragsFromShelf('infrared', bo.port('4'))
      await bo.seesAtPort('4', 'infrared')
      await bo.closes()
      // Only rays of sensors that the program reads are shown, until all are asked for.
      await expect
        .poll(async () => (await child.painted.places()).map(({ name }) => name))
        .toContain('bo ray 2')
      await expect.poll(ray).toBeUndefined()
      await child.presses('lab.worldSettings')
      await child.page.getByText(child.word('lab.allSensors'), { exact: true }).click()
      await child.types('Escape')
      // Nothing is within its 70 cm.
      await expect.poll(async () => (await ray())?.text).toBe('100')
      const { x: left, y: top } = (await ray())!
      // The number's border, in the colour of infrared.
      await expect.poll(() => child.painted.colourAt({ x: left - 23, y: top })).toMatch(/^18\d,5\d,2\d,255$/)
      await bo.opens('senses')
      await expect(bo.sense('mode.infrared', '4')).toHaveText('100')

      // The square is put half a metre ahead of it.
      const project = JSON.parse(await child.savesFile()) as Project
      const { x, y, heading } = project.world.robots[0]!.pose
      const ahead = (cm: number) => ({
        x: x + cm * Math.cos((heading * Math.PI) / 180),
        y: y + cm * Math.sin((heading * Math.PI) / 180),
        heading,
      })
      const obstacles = project.world.obstacles.map((thing) => ({ ...thing, pose: ahead(60) }))
      await child.opensProject(
        'Near',
        JSON.stringify({ ...project, name: 'Near', world: { ...project.world, obstacles } }),
      )
      await expect.poll(async () => Number((await ray())?.text)).toBeLessThan(80)
      const reading = Number((await ray())!.text)
      expect(reading).toBeGreaterThan(10)
    })

    test('is rebuilt by keys alone', async ({ child }) => {
      const bo = new RobotHands(child)
      await child.opensLab('friendship')
      await bo.opens('build')
      await child.tabsTo(bo.onShelf('gyro'))
      await child.types('Enter')
      await bo.seesAtPort('4', 'gyro')
      await child.tabsTo(bo.onShelf('compass'))
      await child.types('Enter')
      await expect(bo.dialog.getByText(bo.word('full'))).toBeVisible()

      await bo.mark('ultrasonic', '3').focus()
      await child.types('ArrowDown', 'ArrowLeft', '.')
      const place = [
        bo.word('ahead', { length: (9.5).toLocaleString(language) }),
        bo.word('toRight', { length: (3.5).toLocaleString(language) }),
        bo.word('turnedRight', { degrees: 25 }),
      ].join(', ')
      await expect(bo.dialog.getByText(place)).toBeVisible()
      await bo.mark('colour', '1').focus()
      await child.types('Delete')
      await bo.seesAtPort('1', null)
    })

    test('can be made like a real one, and stays so', async ({ child }) => {
      const bo = new RobotHands(child)
      await child.opensLab('friendship')
      await bo.opens('build')
      await bo.slider('delay').focus()
      await child.types('ArrowRight', 'ArrowRight', 'ArrowRight')
      await expect(bo.slider('delay')).toHaveAttribute(
        'aria-valuetext',
        spoken(bo.word('seconds', { seconds: (0.15).toLocaleString(language) })),
      )
      await bo.slider('unequal').focus()
      await child.types('ArrowLeft')
      await expect(bo.slider('unequal')).toHaveAttribute(
        'aria-valuetext',
        spoken(bo.word('leftWeaker', { percent: 1 })),
      )
      await bo.closes()
      await child.seesSaved()
      await child.reloads()
      await bo.opens('build')
      await expect(bo.slider('delay')).toHaveValue('9')
      await expect(bo.slider('unequal')).toHaveValue('-1')
    })

    test('a sensor from the shelf goes where it is dropped on the body, and nowhere beside it', async ({
      child,
    }) => {
      const bo = new RobotHands(child)
      await child.opensLab('friendship')
      await bo.opens('build')
      await bo.dragsFromShelf('compass', bo.dialog.getByRole('heading', { level: 2 }))
      await bo.seesAtPort('4', null)
      await bo.dragsFromShelf('compass', bo.mark('colour', '1'))
      await bo.seesAtPort('4', 'compass')
      await expect(bo.dialog).toContainText(bo.word('ahead', { length: 5 }))
    })

    test('shows everything it senses, as it is now', async ({ child }) => {
      const bo = new RobotHands(child)
      await child.opensLab('friendship')
      await bo.opens('senses')
      const distance = bo.sense('mode.distance', '2')
      await expect(distance).toHaveText(/^\d+ cm$/)
      await expect(bo.sense('mode.colour', '1')).toHaveText(child.word('choice.white'))
      await expect(bo.sense('motor', 'B')).toHaveText(/^0 %, 0°$/)
      const before = await distance.textContent()
      await child.page.getByRole('application', { name: child.word('world.label') }).focus()
      await child.page.keyboard.down('ArrowLeft')
      await expect(distance).not.toHaveText(before ?? '')
      await child.page.keyboard.up('ArrowLeft')
      await expect(bo.sense('motor', 'B')).not.toHaveText(/, 0°$/)
    })

    test('has keys of its own, by mouse and by keyboard, a lamp and a display', async ({ child }) => {
      const bo = new RobotHands(child)
      await child.opensProjectAtHome('Keys', keyProgram())
      await bo.opens('panel')
      await child.pressesStart()
      await expect(bo.lamp('red')).toBeVisible()
      await expect(bo.drawer('panel').getByLabel(bo.word('display'))).toHaveText('42')
      await bo.key('enter').hover()
      await child.page.mouse.down()
      await expect(bo.lamp('green')).toBeVisible()
      await child.page.mouse.up()
      await expect(bo.lamp('red')).toBeVisible()

      await bo.key('enter').focus()
      await child.page.keyboard.down(' ')
      await expect(bo.lamp('green')).toBeVisible()
      await child.page.keyboard.up(' ')
      await expect(bo.lamp('red')).toBeVisible()
      await child.page.keyboard.press('Tab')
      await child.page.keyboard.press('Enter')
      await expect(bo.lamp('red')).toBeVisible()
    })

    test('the plus of the network offers what is plugged in, and plugs in nothing', async ({ child }) => {
      const bo = new RobotHands(child)
      await child.opensLab('friendship')
      const links = child.knobs
      await expect(links).toHaveCount(4)
      const light = child.nameOf({ sensor: 'light', port: '1', place: 'front' })
      await child.plus('addSensor').click()
      await expect(child.offered.filter({ hasText: light })).toHaveCount(1)
      // Both distance sensors are in the network already.
      await expect(child.offered.filter({ hasText: child.nameOf(leftEye).split(',')[0]! })).toHaveCount(0)
      await child.page.keyboard.press('Escape')
      await expect(child.offered).toHaveCount(0)
      await child.addsNeuron('addSensor', light)
      await expect(links).toHaveCount(6)
      await bo.opens('build')
      await bo.seesAtPort('4', null)
      await bo.closes()
      await child.presses('lab.undo')
      await expect(links).toHaveCount(4)
    })

    test('two neurons for one motor get a hint at the lower one, and drive', async ({ child }) => {
      await child.opensProjectAtHome(
        'Friendship',
        projectFile('friendship', 'solution').replace('MOTORPORT_B', 'MOTORPORT_C'),
      )
      const title = child.word('problem.sameMotor.title', { port: 'C' })
      const hint = child.canvas.getByRole('button', { name: child.word('editor.finding', { title }) }).first()
      await expect(hint).toBeVisible()
      await child.pressesStart()
      await child.pressesStop()
      await hint.click()
      await expect(said(child, 'sameMotor', { port: 'C' })).toBeVisible()
      await child.presses('problem.fix.motor', { port: 'B' })
      await expect(hint).toBeHidden()
    })
  })
}
