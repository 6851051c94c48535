import { expect, type Locator } from '@playwright/test'
import { BlockHands } from './child-blocks.ts'
import { leftEye, leftWheel, type Child } from './child.ts'

/** What a child does with a network that has to get into the program. */
export class LooseHands {
  readonly child: Child

  constructor(child: Child) {
    this.child = child
  }

  get note(): Locator {
    return this.child.page
      .getByRole('status')
      .filter({ hasText: this.child.word('problem.looseNetwork.title') })
  }

  /** What is written in the ring of the left wheel. */
  #value() {
    return this.child.painted.textIn(this.child.output(leftWheel))
  }

  /** The network's node shows a number: it runs, or would. */
  async seesNumbers() {
    await expect(this.child.knobs).toHaveCount(4)
    await expect(this.note).toHaveCount(0)
    await expect.poll(() => this.#value()).toMatch(/\d/)
  }

  async saysWouldBe(would = true) {
    const { child } = this
    const output = child.word('neuron.motor', { OUTPUTNODE: leftWheel.motor })
    const sum = child.page.getByRole('group', { name: child.word('network.sum', { output }) })
    await expect(sum.getByText(child.word('network.would', { output }))).toHaveCount(would ? 1 : 0)
  }

  async seesLoose() {
    await expect(this.note).toBeVisible()
    await expect.poll(() => this.#value()).toBe('–')
    await expect(this.child.knob(leftEye, leftWheel)).toBeVisible()
  }

  /** Without a network its pane is folded away, but on a phone, where it has a page of its own. */
  async unfolds() {
    if (!(await this.child.words('network.empty').isVisible())) await this.child.presses('lab.unfoldNetwork')
  }

  /** Pulls the network of the toolbox over the place where the network is to be, and lets it go there. */
  async dropsNetwork() {
    const { page } = this.child
    await this.unfolds()
    await new BlockHands(this.child).row('network').click()
    const block = page.locator('.blocklyFlyout .ai_neural_network').first()
    await expect(block).toBeVisible()
    const { x, y } = (await block.boundingBox())!
    await this.child.drags(
      { x: x + 12, y: y + 14 },
      await this.child.middleOf(this.child.words('network.empty')),
    )
  }
}
