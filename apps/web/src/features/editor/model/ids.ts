import * as Blockly from 'blockly/core'

const letters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ'
const signs = letters + '0123456789'

/** 20 letters and digits, the first a letter: 118 random bits that are safe in CSS, ARIA and XML. */
export function plainId(): string {
  const picked = crypto.getRandomValues(new Uint32Array(20))
  return Array.from(picked, (number, at) => {
    const from = at === 0 ? letters : signs
    return from[number % from.length]
  }).join('')
}

/**
 * Makes every id that Blockly gives plain. Its own ids hold characters that break `aria-owns` (a list parted
 * by spaces is fine, but `%`, `#` and quotes are not) and axe reports them; there is no option for it.
 */
export function usePlainIds(): void {
  Blockly.utils.idGenerator.TEST_ONLY.genUid = plainId
}
