import { expect, type Locator } from '@playwright/test'
import type { Child } from './child.ts'

type Kind =
  'ultrasonic' | 'colour' | 'touch' | 'gyro' | 'infrared' | 'sound' | 'compass' | 'position' | 'irseeker'

/** What a child does with the robot itself: rebuild it, look what it senses, press its keys. */
export class RobotHands {
  readonly #child: Child

  constructor(child: Child) {
    this.#child = child
  }

  word = (key: string, facts = {}) => this.#child.word(`robot.${key}`, facts)

  // ---- opening ----

  /** Opens one of the entries in the world's menu; where its head has no room for one, they are in the lab's. */
  async opens(entry: 'build' | 'senses' | 'panel') {
    const hasRoom = await this.#child.button('lab.worldSettings').isVisible()
    await this.#child.presses(hasRoom ? 'lab.worldSettings' : 'lab.menu')
    const name = this.word(entry)
    if (entry === 'build') await this.#child.page.getByRole('button', { name, exact: true }).click()
    else await this.#child.page.getByText(name, { exact: true }).first().click()
    await expect(entry === 'build' ? this.dialog : this.drawer(entry)).toBeVisible()
  }

  get dialog(): Locator {
    return this.#child.page.getByRole('dialog', { name: this.word('build') })
  }

  async closes() {
    await this.dialog.getByRole('button', { name: this.#child.word('parts.close'), exact: true }).click()
    await expect(this.dialog).toBeHidden()
  }

  drawer(what: 'senses' | 'panel'): Locator {
    return this.#child.page.getByRole('region', { name: this.word(what), exact: true })
  }

  // ---- rebuilding ----

  /** A sensor in the picture. */
  mark(kind: Kind, port: string): Locator {
    const name = this.word('mark', { sensor: this.word(`kind.${kind}`), port })
    return this.dialog.getByRole('group', { name: this.word('picture') }).getByRole('button', { name })
  }

  port(port: string): Locator {
    return this.dialog.locator(`[data-port="${port}"]`)
  }

  /** A sensor on the shelf; a plugged one has the same name in the list of ports. */
  onShelf(kind: Kind): Locator {
    return this.dialog.getByRole('button', { name: this.word(`kind.${kind}`), exact: true }).last()
  }

  async dragsFromShelf(kind: Kind, to: Locator) {
    const from = await this.#child.middleOf(this.onShelf(kind))
    await this.#child.drags(from, await this.#child.middleOf(to))
  }

  async dragsMark(kind: Kind, port: string, by: { x: number; y: number }) {
    const from = await this.#child.middleOf(this.mark(kind, port))
    await this.#child.drags(from, { x: from.x + by.x, y: from.y + by.y })
  }

  async seesAtPort(port: string, kind: Kind | null) {
    await expect(this.port(port)).toContainText(
      kind === null ? this.word('empty') : this.word(`kind.${kind}`),
    )
  }

  /** A motor port in the list. */
  motor(port: string): Locator {
    return this.dialog.locator(`[data-motor="${port}"]`)
  }

  /** Chooses what a motor that is tapped does, or what is plugged in there. */
  async sets(port: string, setting: 'plugged' | 'wheel' | 'turns' | 'power', to: string) {
    await this.motor(port).getByRole('button').click()
    await this.setting(setting).selectOption({ label: this.word(to) })
  }

  readonly setting = (setting: 'plugged' | 'wheel' | 'turns' | 'power'): Locator => {
    return this.dialog.getByRole('combobox', { name: this.word(setting), exact: true })
  }

  slider(label: string): Locator {
    return this.dialog.getByRole('slider', { name: this.word(label) })
  }

  // ---- sensing ----

  /** What stands in the table behind a name. */
  sense(mode: string, place: string): Locator {
    return this.drawer('senses')
      .getByRole('row')
      .filter({ hasText: new RegExp(`^\\s*${place}\\s*${this.word(mode)}`) })
      .getByRole('cell')
      .last()
  }

  // ---- the panel ----

  key(key: 'enter' | 'up' | 'down' | 'left' | 'right' | 'escape'): Locator {
    return this.drawer('panel').getByRole('button', { name: this.word(`key.${key}`) })
  }

  lamp(colour: 'green' | 'orange' | 'red' | 'off'): Locator {
    return this.drawer('panel').getByRole('img', { name: this.word(`led.${colour}`) })
  }
}
