// Parts of drawings, of which screen readers hear nothing.
import { expect, type Page } from '@playwright/test'

/** Elements by their selectors, with the attributes without which they are not seen. */
export type Parts = Readonly<Record<string, readonly string[]>>

/** Waits until all these elements have their attributes. */
export async function seesParts(page: Page, parts: Parts) {
  const lacking = () =>
    page.evaluate(
      (parts) =>
        Object.entries(parts).flatMap(([part, names]) =>
          [...document.querySelectorAll(part)].flatMap((one) =>
            names
              .filter((name) => !one.hasAttribute(name))
              .map((name) => `${one.outerHTML.slice(0, 80)} has no ${name}`),
          ),
        ),
      parts,
    )
  await expect.poll(lacking).toEqual([])
}
