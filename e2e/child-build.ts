import { expect, type Locator } from '@playwright/test'
import { readFile } from 'node:fs/promises'
import type { Child } from './child.ts'
import type { Spot } from './hand.ts'

type Shape = 'rectangle' | 'triangle' | 'circle'

/** What a child does while it builds. */
export class Builder {
  readonly child: Child

  constructor(child: Child) {
    this.child = child
  }

  /** Opens the tools, and looks at all of the world. */
  async begins() {
    await this.child.presses('world.build')
    await expect(this.tool('build.addWall')).toBeVisible()
    await this.child.presses('world.all')
  }

  async ends() {
    await this.child.presses('world.build')
    await expect(this.tool('build.addWall')).toBeHidden()
  }

  tool(key: string, facts = {}): Locator {
    return this.child.button(key, facts)
  }

  async addsThing(shape: Shape) {
    await this.tool('build.addThing', { shape: this.child.word(`build.${shape}`) }).click()
  }

  async addsField(shape: Shape) {
    await this.tool('build.addArea', { shape: this.child.word(`build.${shape}`) }).click()
  }

  /** Everything of a name that can be taken hold of; `name` is a key of words. */
  all(name: string): Locator {
    const thing = this.child.word(name)
    const words = this.child.word('world.at', { thing, x: '-?\\d+', y: '-?\\d+' })
    return this.child.page.getByRole('button', { name: new RegExp(`^${words}$`) })
  }

  get things(): Locator {
    return this.world.locator('.grip > button')
  }

  /** Where something says it is, in cm. */
  async placeOf(thing: Locator): Promise<Spot> {
    const [x, y] = (await thing.getAttribute('aria-label'))!.match(/-?\d+/g)!.map(Number)
    return { x: x!, y: y! }
  }

  /**
   * Where the only thing of a world rests, in cm: what was pushed slides on for a moment when the program has ended. Its
   * name follows a run at most ten times a second: it is waited for.
   *
   * @param thing what a hand takes hold of
   */
  async restsAt(thing: Locator): Promise<Spot> {
    const { x, y } = await this.child.page.evaluate(async () => {
      const pose = () => globalThis.botgarten!.view()!.obstacles[0]!.pose
      const frame = () => new Promise(requestAnimationFrame)
      let [still, before] = [0, pose()]
      while (still < 20) {
        await frame()
        const now = pose()
        still = now.x === before.x && now.y === before.y ? still + 1 : 0
        before = now
      }
      return before
    })
    const spot = { x: Math.round(x), y: Math.round(y) }
    await expect.poll(() => this.placeOf(thing)).toEqual(spot)
    return spot
  }

  async chooses(colour: string) {
    await this.tool('build.colour').first().click()
    await this.tool(`build.colours.${colour}`).click()
  }

  /** Types a number into one of the fields of what is selected. */
  async types(field: string, number: string) {
    const input = this.child.page.getByLabel(this.child.word(field), { exact: true })
    if (!(await input.isVisible())) await this.tool('build.numbers').click()
    await input.fill(number)
    await this.child.page.keyboard.press('Enter')
  }

  field(field: string): Locator {
    return this.child.page.getByLabel(this.child.word(field), { exact: true })
  }

  /** The world as it is drawn. */
  get world(): Locator {
    return this.child.page.getByRole('application', { name: this.child.word('world.label') })
  }

  /** A spot of the world's picture, as shares of it. */
  async spot(right: number, down: number): Promise<Spot> {
    const box = (await this.world.boundingBox())!
    return { x: box.x + box.width * right, y: box.y + box.height * down }
  }

  async opensWorldDialog() {
    await this.tool('build.world').click()
    await expect(this.child.dialog('build.world')).toBeVisible()
  }

  /** Chooses a file where the dialog asks for one. */
  async choosesFile(
    button: 'build.ownPicture' | 'build.openScene',
    name: string,
    content: Buffer,
    mimeType = '',
  ) {
    await this.opensWorldDialog()
    const asked = this.child.page.waitForEvent('filechooser')
    await this.tool(button).click()
    await (await asked).setFiles({ name, mimeType, buffer: content })
  }

  async savesScene(): Promise<string> {
    await this.opensWorldDialog()
    const [download] = await Promise.all([
      this.child.page.waitForEvent('download'),
      this.tool('build.saveScene').click(),
    ])
    await this.child.page.keyboard.press('Escape')
    return readFile(await download.path(), 'utf8')
  }

  /** Is told why a file was not taken, and closes that. */
  async seesRefusal(problem: string, facts = {}) {
    const dialog = this.child.dialog(`problem.${problem}.title`)
    await expect(dialog).toBeVisible()
    await expect(dialog).toContainText(this.child.word(`problem.${problem}.text`, facts))
    await dialog.getByRole('button', { name: this.child.word('parts.ok'), exact: true }).click()
    await expect(dialog).toBeHidden()
  }
}
