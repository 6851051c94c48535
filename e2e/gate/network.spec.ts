import { NetHands } from '../child-network.ts'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { expect, opensCard, poseOf, test } from './gate.ts'

test.use({ language: 'de' })

/** The reading of Bo's left eye, in cm. */
const leftReads = (child: Child) =>
  child.page.evaluate(() => Object.values(globalThis.botgarten!.view()!.networks)[0]!.outputs['eyeLeft']!)

/** How far Bo has turned after a moment of driving, in degrees: left is above 0. */
async function turns(child: Child): Promise<number> {
  const before = await poseOf(child)
  await child.pressesStart()
  await child.seesDriving()
  await child.watches(10)
  await child.pressesStop()
  const after = await poseOf(child)
  await child.presses('lab.resetWorld')
  return ((after.heading - before.heading + 540) % 360) - 180
}

test(
  'a knob pulled by hand changes the sum, the number of the motor and the way of Bo',
  {
    tag: ['@network', '@/lab/[card]'],
  },
  async ({ child, page }) => {
    await opensCard(child, 'friendship')
    await child.pressesStart()
    await child.seesStanding()
    await child.pressesStop()
    await child.dragsKnob(leftEye, leftWheel, 0.5)
    const output = child.word('neuron.motor', { OUTPUTNODE: leftWheel.motor })
    await child.output(leftWheel).click()
    const sum = page.getByRole('group', { name: child.word('network.sum', { output }) })
    // Half of the left eye's reading; the right eye has weight 0.
    const half = String(Math.round((await leftReads(child)) * 0.5))
    await expect(sum.locator('.whole').last()).toHaveText(half)
    await expect.poll(() => child.painted.textIn(child.output(leftWheel))).toBe(half)
    await expect.poll(() => child.painted.textIn(child.output(rightWheel))).toBe('0')

    // The left wheel alone turns Bo to the right, the right one to the left.
    expect(await turns(child)).toBeLessThan(-1)
    await child.typesWeight(leftEye, leftWheel, 0)
    await child.typesWeight(rightEye, rightWheel, 0.5)
    expect(await turns(child)).toBeGreaterThan(1)
    await child.presses('lab.undo')
    await child.presses('lab.undo')
    await child.seesWeight(leftEye, leftWheel, 0.5)
    await child.seesWeight(rightEye, rightWheel, 0)
  },
)

test(
  'a hidden layer adds what comes in and a bias, goes with undo, and a brain is taken from the shelf',
  {
    tag: '@network',
  },
  async ({ child }) => {
    const net = new NetHands(child)
    await opensCard(child, 'friendship')
    await net.chooses('explorer')
    await child.presses('net.addLayer')
    await expect(child.knobs).toHaveCount(12)
    await child.presses('net.fewer', { layer: 1 })
    await expect(child.knobs).toHaveCount(8)
    const hidden = child.word('net.hidden', { layer: 1, neuron: 1 })
    await child.knobs.first().focus()
    await child.types(...(-0.5).toLocaleString('de'), 'Enter')
    await expect(child.knobs.first()).toHaveAttribute('aria-valuenow', '-0.5')
    await net.bias(hidden).fill('80')
    await net.bias(hidden).press('Enter')
    const value = String(Math.round(80 - 0.5 * (await leftReads(child))))
    await expect.poll(() => child.painted.textIn(net.neuron(1, 1))).toBe(value)
    await child.presses('net.fewer', { layer: 1 })
    await child.presses('net.removeLayer', { layer: 1 })
    await expect(child.knobs).toHaveCount(4)
    await child.presses('lab.undo')
    await expect.poll(() => child.painted.textIn(net.neuron(1, 1))).toBe(value)
    await child.presses('lab.redo')

    await child.typesWeight(rightEye, leftWheel, 0.75)
    await net.opensShelf()
    await net.putsOnShelf('mild')
    await child.types('Escape')
    await child.page.getByTitle(child.word('lab.resetWeights')).click()
    await child.seesWeight(rightEye, leftWheel, 0)
    await net.opensShelf()
    await child.presses('net.take')
    await net.isTold('net.taken', { name: 'mild' })
    await child.types('Escape')
    await child.seesWeight(rightEye, leftWheel, 0.75)
  },
)
