import type { Page } from '@playwright/test'

declare global {
  var keeps: IDBObjectStore['put'] | undefined
}

/** From now on this page's storage refuses to keep anything; or it keeps things again. */
export const refusesToKeep = (page: Page, refuses: boolean) =>
  page.evaluate((no) => {
    const store = IDBObjectStore.prototype
    const put = (globalThis.keeps ??= Object.getOwnPropertyDescriptor(store, 'put')!
      .value as IDBObjectStore['put'])
    store.put = no
      ? () => {
          throw new DOMException('Refused for a test.', 'QuotaExceededError')
        }
      : put
  }, refuses)
