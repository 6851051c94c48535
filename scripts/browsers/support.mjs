// Which versions of browsers have an API: MDN's table of compatibility (@mdn/browser-compat-data).
import data from '@mdn/browser-compat-data' with { type: 'json' }

/** @typedef {{ readonly [name: string]: any }} Tree */
/** @typedef {{ readonly browser: string, readonly since: string | null }} Missing */

/** The table; an entry at `a.b` has its versions in `__compat.support`. @type {Tree} */
export const table = data

/** @param {string} path such as `api.URL.parse_static` @returns {Tree | null} */
export function entryAt(path) {
  /** @type {any} */
  let found = table
  for (const name of path.split('.')) {
    if (typeof found !== 'object' || !Object.hasOwn(found, name)) return null
    found = found[name]
  }
  return found
}

/** `16.4` as a number that can be compared; null if no version has it, or only one that is not released yet. @param {unknown} version */
function numberOf(version) {
  const [, major, minor = '0'] = /^≤?(\d+)(?:\.(\d+))?/.exec(String(version)) ?? []
  return major === undefined ? null : Number(major) * 1000 + Number(minor)
}

/**
 * The first version that has it by its own name and without a setting; null: none.
 * @param {any} support @param {boolean} prefixed a name with a prefix counts as well
 */
function sinceOf(support, prefixed = false) {
  const plain = [support ?? []]
    .flat()
    .filter((one) => !one.flags && (prefixed || !one.prefix) && !one.alternative_name)
  // Newest first. An entry that ends where the one above it begins is the same API with a note, such as a part that it lacked.
  let since = null
  for (const { version_added: from, version_removed: to } of plain) {
    if (numberOf(from) === null || (to && to !== since)) break
    since = from
  }
  return /** @type {string | null} */ (since)
}

/** Safari on an iPad is a browser of its own in the table. */
const sameAs = { safari: ['safari', 'safari_ios'], firefox: ['firefox'], chrome: ['chrome'], edge: ['edge'] }

/**
 * Promised browsers that do not have it, and the version that does.
 * @param {Tree} entry @param {{ readonly [browser: string]: string }} promised
 * @param {boolean} [prefixed] a name with a prefix counts as well: the build writes those of CSS
 * @returns {readonly Missing[]}
 */
export function missingIn(entry, promised, prefixed = false) {
  const support = entry['__compat']?.support
  if (!support) return []
  return Object.entries(promised).flatMap(([browser, oldest]) =>
    sameAs[/** @type {keyof typeof sameAs} */ (browser)].flatMap((name) => {
      const since = sinceOf(support[name], prefixed)
      const isThere = since !== null && Number(numberOf(since)) <= Number(numberOf(oldest))
      return isThere ? [] : [{ browser: name, since }]
    }),
  )
}

/** First versions of Safari, Firefox and Chrome, by its own name; a dash: none. @param {Tree} entry */
export function versionsOf(entry) {
  const support = entry['__compat']?.support ?? {}
  return ['safari', 'firefox', 'chrome'].map((name) => sinceOf(support[name]) ?? '–')
}

/**
 * Static members and global names that a promised browser lacks: for lint, which knows no types.
 * @param {{ readonly [browser: string]: string }} promised
 * @returns {{ readonly properties: readonly { object: string, property: string }[], readonly globals: readonly string[] }}
 */
export function newerNames(promised) {
  const lacks = (/** @type {Tree} */ entry) => missingIn(entry, promised).length > 0
  const [api, builtins] = [table['api'], table['javascript'].builtins]
  const properties = [
    ...Object.entries(api).flatMap(([object, members]) =>
      Object.entries(members)
        .filter(([name, entry]) => name.endsWith('_static') && lacks(entry))
        .map(([name]) => ({ object, property: name.replace(/_static$/, '') })),
    ),
    ...Object.entries(builtins).flatMap(([object, members]) =>
      Object.entries(members)
        // Members of the prototype are listed together with static ones; the types of ES2023 refuse both.
        .filter(
          ([name, entry]) => name !== '__compat' && name !== object && lacks(/** @type {Tree} */ (entry)),
        )
        .map(([property]) => ({ object, property })),
    ),
  ]
  const globals = [...Object.entries(api), ...Object.entries(builtins)].filter(([, entry]) => lacks(entry))
  return { properties, globals: globals.map(([name]) => name) }
}
