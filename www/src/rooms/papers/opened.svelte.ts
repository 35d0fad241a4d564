import { SvelteSet } from 'svelte/reactivity'

/** The claims that are open, by id. */
export const opened = new SvelteSet<string>()

/** As keys of an address. */
export const openedKeys = (): string => (opened.size > 0 ? `&claims=${[...opened].join()}` : '')
