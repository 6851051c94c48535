/**
 * The oldest versions of browsers in which everything works: README, the page about the lab, the build and the check of APIs
 * take them from here. Safari is that of the iPad with the same version.
 */
export const promised = { safari: '16.4', firefox: '115', chrome: '111', edge: '111' } as const
