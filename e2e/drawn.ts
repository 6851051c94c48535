// Drawings of a page, as lines for the steps of the walk. Screen readers do not see them.
import type { Page } from '@playwright/test'

/** Shapes and placed elements below a selector, with their attributes; long ones are cut, numbers rounded. */
export const drawnIn = (page: Page, selector: string): Promise<readonly string[]> =>
  page.evaluate((drawings) => {
    const shapes = 'svg, g, path, circle, ellipse, rect, polyline, text, img, [style]'
    const rounded = (text: string) =>
      text.replaceAll(/-?\d+\.\d+/g, (number) => `${Math.round(Number(number))}`)
    // The build names files by their content.
    const shortened: { readonly [name: string]: (value: string) => string } = {
      class: (value) => value.replaceAll(/svelte-\w+/g, '').trim(),
      src: (value) => /^data:[^,;]*/.exec(value)?.[0] ?? value.replaceAll(/^.*\/|\..*$/g, ''),
    }
    const shown = ({ name, value }: Attr) => {
      const text = (shortened[name] ?? rounded)(value)
      return text === '' ? [] : [` ${name}="${text.slice(0, 60)}"`]
    }
    return [...document.querySelectorAll(drawings)]
      .flatMap((one) => [...one.querySelectorAll(shapes)])
      .filter((one) => one.checkVisibility())
      .map((one) => {
        const text = one.matches('text') ? ` ${one.textContent.trim()}` : ''
        return `~ ${one.localName}${[...one.attributes].flatMap(shown).join('')}${text}`
      })
  }, selector)
