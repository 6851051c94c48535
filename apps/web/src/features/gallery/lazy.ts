export { default as GalleryPage } from './view/GalleryPage.svelte'
export { default as ShareInClass } from './view/ShareInClass.svelte'
