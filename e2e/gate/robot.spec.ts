import { RobotHands } from '../child-robot.ts'
import { TimeHands } from '../child-time.ts'
import { leftEye, leftWheel, rightWheel } from '../child.ts'
import { expect, opensCard, test } from './gate.ts'

test.use({ language: 'de' })

test(
  'a sensor is plugged in and taken out, what Bo senses is shown as it is, and its keys are there',
  {
    tag: '@robot',
  },
  async ({ child }) => {
    const bo = new RobotHands(child)
    await opensCard(child, 'friendship')
    await bo.opens('build')
    await bo.seesAtPort('4', null)
    await bo.dragsFromShelf('touch', bo.port('4'))
    await bo.seesAtPort('4', 'touch')
    await bo.dragsMark('ultrasonic', '2', { x: 0, y: 56 })
    await expect(bo.dialog).toContainText(bo.word('ahead', { length: 5 }))
    await bo.dialog.getByRole('button', { name: bo.word('remove') }).click()
    await bo.seesAtPort('2', null)
    await bo.closes()
    // The program's sensor is missing now, and one tap plugs it in again.
    const problem = child.word('problem.noDistanceSensorEmpty.title', { port: '2', other: '3' })
    const said = child.page.getByRole('status').filter({ hasText: problem })
    await expect(said).toBeVisible()
    await child.presses('problem.fix.plug', { port: '2' })
    await expect(said).toBeHidden()

    await bo.opens('senses')
    const distance = bo.sense('mode.distance', '2')
    await expect(distance).toHaveText(/^\d+ cm$/)
    await expect(bo.sense('mode.colour', '1')).toHaveText(child.word('choice.white'))
    const before = await distance.textContent()
    await child.page.getByRole('application', { name: child.word('world.label') }).focus()
    await child.page.keyboard.down('ArrowLeft')
    await expect(distance).not.toHaveText(before!)
    await child.page.keyboard.up('ArrowLeft')
    await bo.opens('panel')
    await expect(bo.key('enter')).toBeVisible()
  },
)

test(
  'a second robot runs the same program with weights of its own, and goes with undo',
  {
    tag: '@robots',
  },
  async ({ child }) => {
    const robots = new TimeHands(child)
    await opensCard(child, 'friendship')
    await child.presses('lab.card')
    await child.presses('robots.beside', { card: child.card('fear') })
    await expect(robots.row.getByRole('button', { pressed: true })).toContainText(child.card('fear'))
    await child.seesWeight(leftEye, rightWheel, 0.8)
    const facts = { name: robots.robotName(1), count: 2, of: 4 }
    await expect(child.words('robots.differ', facts)).toBeVisible()
    await child.presses('lab.undo')
    await expect(robots.row).toHaveCount(0)

    await child.typesWeight(leftEye, leftWheel, 0.5)
    await robots.adds('shared')
    await expect(robots.chip(2)).toHaveAttribute('aria-pressed', 'true')
    await child.seesWeight(leftEye, leftWheel, 0.5)
    await child.typesWeight(leftEye, leftWheel, 0)
    const [first, second] = [await robots.stands(1), await robots.stands(2)]
    await child.pressesStart()
    await expect.poll(() => robots.stands(1)).not.toBe(first)
    await expect.poll(() => robots.stands(2)).toBe(second)
    await child.pressesStop()
    await child.typesWeight(leftEye, rightWheel, 0.3)
    await robots.chip(1).click()
    await child.seesWeight(leftEye, leftWheel, 0.5)
    await child.seesWeight(leftEye, rightWheel, 0)
    await robots.chip(2).click()
    await child.presses('robots.remove', { name: robots.robotName(2) })
    await expect(robots.robot(2)).toHaveCount(0)
    await child.presses('lab.undo')
    await expect(robots.robot(2)).toBeVisible()
  },
)
